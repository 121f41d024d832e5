// Several documents in one window, by mouse and keys.

#include "ui/documents/document_tabs.h"

#include <QImage>
#include <QSettings>
#include <QTabBar>
#include <QtTest>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/workspace.h"
#include "ui/documents/document_page.h"
#include "ui/view/viewport.h"
#include "ui/widgets/progress_strip.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kTabPatienceMs = 60000;

class DocumentTabsTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                       QString::fromStdString(folder_.path().string()));
    QCoreApplication::setOrganizationName("cutis-test");
    for (const auto& [name, color] :
         {std::pair("one.png", QColor(200, 150, 130)), std::pair("two.png", QColor(120, 80, 60))}) {
      QImage image(40, 30, QImage::Format_RGB32);
      image.fill(color);
      QVERIFY(image.save(file(name)));
    }
  }

  void oneDocumentNeedsNoTab() {
    open("one.png");
    QCOMPARE(window_->tabs().count(), 1);
    QVERIFY(!bar().isVisible());
  }

  void eachKeepsItsEdits() {
    open("one.png");
    window_->edits().setFactor(kMelanin, 2.0, false);
    open("two.png");
    QVERIFY(bar().isVisible());
    QVERIFY(window_->windowTitle().contains("two.png"));
    QVERIFY(!window_->document().history().canUndo());
    QTest::mouseClick(&bar(), Qt::LeftButton, {}, bar().tabRect(0).center());
    QVERIFY(window_->windowTitle().contains("one.png"));
    QVERIFY(window_->document().history().canUndo());
    QVERIFY(window_->commands().action("edit.undo")->isEnabled());
  }

  void keysGoRound() {
    open("one.png");
    open("two.png");
    activate();
    QTest::keyClick(&window_->viewport(), Qt::Key_Tab, Qt::ControlModifier);
    QVERIFY(window_->windowTitle().contains("one.png"));
    QTest::keyClick(&window_->viewport(), Qt::Key_PageUp, Qt::ControlModifier);
    QVERIFY(window_->windowTitle().contains("two.png"));
  }

  void whatIsOpenComesToTheFront() {
    open("one.png");
    open("two.png");
    open("one.png");
    QCOMPARE(window_->tabs().count(), 2);
    QVERIFY(window_->windowTitle().contains("one.png"));
  }

  void whatCannotBeOpenedLeavesNoTab() {
    open("one.png");
    folder_.write("noise.png", "this is no picture");
    open("noise.png");
    QCOMPARE(window_->tabs().count(), 1);
    QTRY_COMPARE(window_->tabs().pages().size(), 1u);
    QVERIFY(window_->windowTitle().contains("one.png"));
    QVERIFY(window_->progress().message().contains("noise.png"));
  }

  void aTabIsClosedByItsButtonAndByTheMiddleOne() {
    open("one.png");
    open("two.png");
    open("one.png");
    QTest::mouseClick(&bar(), Qt::MiddleButton, {}, bar().tabRect(1).center());
    QCOMPARE(window_->tabs().count(), 1);
    QVERIFY(window_->windowTitle().contains("one.png"));
    open("two.png");
    QWidget* button = bar().tabButton(1, QTabBar::RightSide);
    QVERIFY(button != nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    QTRY_COMPARE(window_->tabs().count(), 1);
    QVERIFY(window_->windowTitle().contains("one.png"));
  }

  // And nothing is open any more.
  void theLastOneLeavesTheStartPage() {
    open("one.png");
    activate();
    QTest::keyClick(&window_->viewport(), Qt::Key_W, Qt::ControlModifier);
    QTRY_COMPARE(window_->windowTitle(), QString("Cutis"));
    QVERIFY(!window_->document().isOpen());
    QCOMPARE(window_->tabs().pages().size(), 1u);
    open("two.png");
    QVERIFY(window_->windowTitle().contains("two.png"));
  }

  void closingWhileItIsFittedIsSafe() {
    window_->opener().openSample();
    QTRY_VERIFY_WITH_TIMEOUT(window_->document().isOpen(), kTabPatienceMs);
    window_->commands().run("file.close");
    waitUntilIdle();
    QVERIFY(!window_->document().isOpen());
    QVERIFY(window_->progress().message().isEmpty());
  }

  void docksStandTheSameWay() {
    open("one.png");
    window_->commands().run("dock.light");
    open("two.png");
    QTRY_VERIFY(window_->workspace().dock("light")->isHidden());
    QVERIFY(!window_->workspace().dock("edit")->isHidden());
  }

 private:
  void setUp() override {
    QSettings().clear();
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->resize(1280, 900);
    window_->show();
  }
  void tearDown() override { window_.reset(); }

  QTabBar& bar() const { return *window_->tabs().findChild<QTabBar*>(); }
  QString file(const std::string& name) const {
    return QString::fromStdString((folder_ / name).string());
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kTabPatienceMs);
  }
  void open(const std::string& name) {
    window_->opener().open(file(name));
    waitUntilIdle();
  }
  void activate() {
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  }

  test::ScratchFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(DocumentTabsTest)

}  // namespace
}  // namespace cutis

#include "document_tabs_test.moc"
