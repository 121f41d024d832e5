#include "ui/window/window_size.h"

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class WindowSizeTest : public QObject {
  Q_OBJECT

 private slots:
  void windowsStayWithinTheScreen_data() {
    QTest::addColumn<QRect>("wanted");
    QTest::addColumn<QRect>("screen");
    const QRect first(0, 0, 1440, 900);
    for (const QSize size : {QSize(772, 510), QSize(1440, 900), QSize(960, 540), QSize(3840, 2160)})
      QTest::addRow("%d x %d", size.width(), size.height()) << first << QRect({0, 0}, size);
    QTest::newRow("gone to the left") << QRect(-3000, 100, 800, 600) << QRect(0, 0, 1920, 1080);
    QTest::newRow("gone below") << QRect(100, 5000, 800, 600) << QRect(0, 0, 1920, 1080);
    QTest::newRow("second screen") << first << QRect(1920, 200, 1280, 720);
  }
  void windowsStayWithinTheScreen() {
    QFETCH(QRect, wanted);
    QFETCH(QRect, screen);
    const QRect placed = withinScreen(wanted, screen);
    // With a frame about it.
    QVERIFY(screen.contains(placed.adjusted(-4, -28, 4, 4)));
    QVERIFY(placed.width() <= wanted.width() && placed.height() <= wanted.height());
  }

  void whatFitsStaysAsItIs() {
    const QRect wanted(300, 200, 800, 600);
    QCOMPARE(withinScreen(wanted, {0, 0, 1920, 1080}), wanted);
  }
};

CUTIS_TEST(WindowSizeTest)

}  // namespace
}  // namespace cutis

#include "window_size_test.moc"
