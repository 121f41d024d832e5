#include "ui/window/start_page.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/widgets/recent_list.h"

namespace cutis {
namespace {

class StartPageTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void buttonsAsk() {
    StartPage page;
    QSignalSpy sample(&page, &StartPage::sampleWanted);
    QSignalSpy capture(&page, &StartPage::captureWanted);
    QSignalSpy image(&page, &StartPage::imageWanted);
    const auto buttons = page.findChildren<QPushButton*>();
    QCOMPARE(buttons.size(), 3);
    for (QPushButton* button : buttons)
      QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(sample.count() + capture.count() + image.count(), 3);
    QCOMPARE(sample.count(), capture.count());
  }

  // Where the eyes are.
  void messagesStandBelowTheDropArea() {
    StartPage page;
    page.resize(900, 700);
    page.show();
    QLabel* message = nullptr;
    for (QLabel* label : page.findChildren<QLabel*>()) {
      if (label->accessibleName() == "Message") message = label;
    }
    QVERIFY(message != nullptr && !message->isVisible());
    page.showMessage("a.png: the file ends early", true);
    QVERIFY(message->isVisible());
    QCOMPARE(message->text(), QString("a.png: the file ends early"));
    page.showMessage({}, false);
    QVERIFY(!message->isVisible());
  }

  void recentFilesOpenByClickAndKey() {
    StartPage page;
    page.resize(900, 700);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    auto* list = page.findChild<RecentList*>();
    QVERIFY(!list->isVisible());
    page.setRecentFiles({"/data/one.cutis", "/data/two.cutis"});
    QTRY_VERIFY(list->isVisible());
    QSignalSpy file(&page, &StartPage::fileWanted);
    QTRY_VERIFY(list->viewport()->rect().contains(list->visualItemRect(list->item(1)).center()));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(1)).center());
    QCOMPARE(file.count(), 1);
    QCOMPARE(file[0][0].toString(), QString("/data/two.cutis"));
    QTest::keyClick(list, Qt::Key_Up);
    QTest::keyClick(list, Qt::Key_Return);
    QCOMPARE(file[1][0].toString(), QString("/data/one.cutis"));
  }
};

CUTIS_TEST(StartPageTest)

}  // namespace
}  // namespace cutis

#include "start_page_test.moc"
