#include "ui/view/view_strip.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

const QVector<ViewEntry> kViews = {{"photo", "Photograph", "As taken"},
                                   {"melanin", "Melanin", "Volume fraction"},
                                   {"uva", "UVA", "Extrapolated"}};

class ViewStripTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void viewsComeSilently() {
    ViewStrip strip;
    const QAbstractItemModelTester tester(strip.model());
    QSignalSpy chosen(&strip, &ViewStrip::chosen);
    strip.setViews(kViews);
    QCOMPARE(strip.current(), QString("photo"));
    strip.setCurrent("uva");
    QCOMPARE(strip.current(), QString("uva"));
    strip.setViews(kViews);
    QCOMPARE(strip.current(), QString("uva"));
    QCOMPARE(chosen.count(), 0);
    QCOMPARE(strip.width(), 152);
  }

  void clicksAndKeysChoose() {
    ViewStrip strip;
    strip.setViews(kViews);
    strip.resize(132, 500);
    strip.show();
    QVERIFY(QTest::qWaitForWindowExposed(&strip));
    QSignalSpy chosen(&strip, &ViewStrip::chosen);
    QTest::mouseClick(strip.viewport(), Qt::LeftButton, {},
                      strip.visualItemRect(strip.item(1)).center());
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen.last()[0].toString(), QString("melanin"));
    QTest::keyClick(&strip, Qt::Key_Down);
    QCOMPARE(chosen.last()[0].toString(), QString("uva"));
  }

  void theRightButtonChoosesNothing() {
    ViewStrip strip;
    strip.setViews(kViews);
    strip.resize(132, 500);
    strip.show();
    QVERIFY(QTest::qWaitForWindowExposed(&strip));
    QTest::mouseClick(strip.viewport(), Qt::RightButton, {},
                      strip.visualItemRect(strip.item(1)).center());
    QCOMPARE(strip.current(), QString("photo"));
  }

  // Groups have headings, which are no views.
  void headingsAreNotChosen() {
    ViewStrip strip;
    strip.setViews({{"photo", "Photograph", {}, "Pictures"},
                    {"skin", "Skin", {}, "Pictures"},
                    {"melanin", "Melanin", {}, "Maps"}});
    QCOMPARE(strip.count(), 5);
    QCOMPARE(strip.current(), QString("photo"));
    strip.resize(152, 500);
    strip.show();
    QVERIFY(QTest::qWaitForWindowExposed(&strip));
    QTest::keyClick(&strip, Qt::Key_Down);
    QTest::keyClick(&strip, Qt::Key_Down);
    QCOMPARE(strip.current(), QString("melanin"));
    QTest::mouseClick(strip.viewport(), Qt::LeftButton, {},
                      strip.visualItemRect(strip.item(0)).center());
    QCOMPARE(strip.current(), QString("melanin"));
  }

  void aThumbnailTakesThePlaceOfThePlate() {
    ViewStrip strip;
    strip.setViews(kViews);
    strip.resize(132, 500);
    strip.show();
    QVERIFY(QTest::qWaitForWindowExposed(&strip));
    const QPoint middle = strip.visualItemRect(strip.item(1)).topLeft() + QPoint(27, 19);
    QImage image(2000, 1000, QImage::Format_RGB32);
    image.fill(qRgb(10, 200, 30));
    strip.setThumbnail("melanin", image);
    strip.setThumbnail("unknown", image);
    QCOMPARE(strip.viewport()->grab().toImage().pixel(middle), qRgb(10, 200, 30));
    strip.setViews(kViews);
    QCOMPARE(strip.viewport()->grab().toImage().pixel(middle), qRgb(10, 200, 30));
  }
};

CUTIS_TEST(ViewStripTest)

}  // namespace
}  // namespace cutis

#include "view_strip_test.moc"
