// Several documents in one window, by mouse and keys.

#include "ui/documents/document_tabs.h"

#include <QDropEvent>
#include <QElapsedTimer>
#include <QImage>
#include <QLineEdit>
#include <QMimeData>
#include <QSettings>
#include <QTabBar>
#include <QtTest>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/workspace.h"
#include "ui/documents/document_page.h"
#include "ui/view/viewport.h"
#include "ui/widgets/neutral_slider.h"
#include "ui/widgets/progress_strip.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kTabPatienceMs = 60000;

class DocumentTabsTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() {
    test::keepSettingsIn(folder_.path());
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

  // The button of the mouse is down on a slider, say.
  void aGestureIsNotTakenAway() {
    open("one.png");
    auto* slider = window_->workspace().dock("edit")->findChild<NeutralSlider*>();
    QVERIFY(slider != nullptr);
    QTest::mousePress(slider, Qt::LeftButton, {}, slider->rect().center());
    open("two.png");
    QVERIFY2(window_->windowTitle().contains("one.png"), "it stays in front");
    QCOMPARE(window_->tabs().count(), 2);
    QVERIFY(window_->progress().message().contains("two.png"));
    QTest::mouseRelease(slider, Qt::LeftButton, {}, slider->rect().center());
    QVERIFY(window_->windowTitle().contains("one.png"));
  }

  void whatIsBeingTypedIsNotTakenAway() {
    open("one.png");
    activate();
    auto* field = window_->workspace().dock("edit")->findChild<QLineEdit*>();
    QVERIFY(field != nullptr);
    field->setFocus();
    QTest::keyClick(field, Qt::Key_2);
    open("two.png");
    QVERIFY(window_->windowTitle().contains("one.png"));
    QVERIFY(field->hasFocus());
  }

  void ofSeveralTheFirstComesToTheFront() {
    open("one.png");
    QImage image(60, 50, QImage::Format_RGB32);
    image.fill(QColor(150, 110, 90));
    for (const char* name : {"c.png", "a.png", "b.png"})
      QVERIFY(image.save(file(name)));
    // Their sizes differ, so that they are no photographs of one scene.
    QVERIFY(image.scaled(61, 50).save(file("a.png")));
    drop({"c.png", "a.png", "b.png"});
    waitUntilIdle();
    QTRY_COMPARE(window_->tabs().count(), 4);
    QVERIFY2(window_->windowTitle().contains("c.png"), qPrintable(window_->windowTitle()));
    for (const auto& [tab, name] : {std::pair(0, "one.png"), std::pair(1, "c.png"),
                                    std::pair(2, "a.png"), std::pair(3, "b.png")})
      QCOMPARE(bar().tabText(tab), QString(name));
  }

  void namesakesAreToldApart() {
    std::filesystem::create_directories(folder_ / "left");
    std::filesystem::copy(folder_ / "two.png", folder_ / "left/one.png",
                          std::filesystem::copy_options::overwrite_existing);
    open("one.png");
    open("left/one.png");
    QCOMPARE(bar().tabText(1), QString("one.png (left)"));
    QVERIFY(bar().tabText(0).startsWith("one.png ("));
    QTest::mouseClick(&bar(), Qt::MiddleButton, {}, bar().tabRect(0).center());
    QTRY_COMPARE(window_->tabs().count(), 1);
    QCOMPARE(bar().tabText(0), QString("one.png"));
  }

  // Whoever the files come from waits for it.
  void aDropReturnsAtOnce() {
    open("one.png");
    QStringList many;
    for (int k = 0; k < 7; ++k) {
      many << QString("many%1.png").arg(k);
      QImage image(40 + k, 30, QImage::Format_RGB32);
      image.fill(QColor(200, 150, 100 + k));
      QVERIFY(image.save(file(many.back().toStdString())));
    }
    QElapsedTimer clock;
    clock.start();
    drop(many);
    QVERIFY2(clock.elapsed() < 100, qPrintable(QString::number(clock.elapsed())));
    QTRY_COMPARE_WITH_TIMEOUT(window_->tabs().count(), 8, kTabPatienceMs);
    waitUntilIdle();
  }

  // The strip at the foot is that of all documents.
  void theReadOutIsThatOfTheDocumentInFront() {
    open("one.png");
    QTest::mouseMove(&window_->viewport(), window_->viewport().rect().center());
    QTRY_VERIFY(readout().contains("Melanin"));
    window_->edits().setFactor(kMelanin, 1.5, false);
    QTRY_VERIFY2(readout().contains("edited"), qPrintable(readout()));
    open("two.png");
    QVERIFY2(!readout().contains("edited"), qPrintable(readout()));
    QTest::mouseClick(&bar(), Qt::LeftButton, {}, bar().tabRect(0).center());
    QVERIFY2(readout().isEmpty(), "the pointer is not on the picture");
    window_->edits().setFactor(kMelanin, 2.0, false);
    QVERIFY(readout().isEmpty());
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
  QString readout() const {
    for (const QWidget* part : window_->progress().findChildren<QWidget*>()) {
      if (part->accessibleDescription() == "Under the cursor") return part->accessibleName();
    }
    return {};
  }
  void drop(const QStringList& names) {
    QMimeData dropped;
    QList<QUrl> urls;
    for (const QString& name : names)
      urls << QUrl::fromLocalFile(file(name.toStdString()));
    dropped.setUrls(urls);
    QDragEnterEvent enter({50, 50}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &enter);
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &event);
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
