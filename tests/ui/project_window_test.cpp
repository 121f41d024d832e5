// Nothing is lost: projects, unsaved edits, moved and changed sources in the window, by mouse and
// keys.

#include <fstream>

#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSysInfo>
#include <QtTest>

#include "src/app/project/manifest.h"
#include "src/files/system/platform.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_controller.h"
#include "ui/dialogs/save_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/menus/private_data.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/progress_strip.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

constexpr int kProjectPatienceMs = 60000;

class ProjectWindowTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() {
    test::keepSettingsIn(folder_.path());
    paint("one.png", QColor(200, 150, 130));
    paint("two.png", QColor(120, 80, 60));
  }

  void editsAreMarkedAndSavedByKey() {
    open("one.png");
    QVERIFY(!window_->isWindowModified());
    edit(2.0);
    QVERIFY(window_->isWindowModified());
    window_->views().show(ViewKind::melanin);
    window_->saves().saveTo(file("one.cutis"));
    waitUntilIdle();
    QVERIFY(!window_->isWindowModified());
    QCOMPARE(window_->windowTitle(), QString("one[*] — Cutis"));
    edit(3.0);
    activate();
    QTest::keyClick(&window_->viewport(), Qt::Key_S, Qt::ControlModifier);
    waitUntilIdle();
    QVERIFY(!window_->isWindowModified());
    QCOMPARE(savedFactor("one.cutis"), 3.0);
    edit(1.5);
    QVERIFY(window_->isWindowModified());
    window_->document().undo();
    QVERIFY2(!window_->isWindowModified(), "undone to what was saved");
  }

  void aProjectOpensAsItWasLookedAt() {
    saveProjectOfOne();
    restart();
    open("one.cutis");
    QVERIFY(window_->windowTitle().startsWith("one"));
    QVERIFY(window_->views().current() == ViewKind::melanin);
    QCOMPARE(window_->viewport().zoom(), 20.0);
    QVERIFY(!window_->isWindowModified());
    QCOMPARE(window_->document().scene().edits.front().parameters[kMelanin].scale, 2.0);
  }

  void closingATabAsks() {
    open("two.png");
    open("one.png");
    edit(2.0);
    window_->commands().run("file.close");
    answer("Cancel");
    QCOMPARE(window_->tabs().count(), 2);
    QVERIFY(window_->isWindowModified());
    window_->commands().run("file.close");
    QVERIFY(question()->text().contains("one.png"));
    answer("Discard");
    QTRY_COMPARE(window_->tabs().count(), 1);
    window_->commands().run("file.close");
    QVERIFY2(question() == nullptr, "there is nothing to save");
    QVERIFY(!window_->document().isOpen());
  }

  void savingOnTheWayOutSaves() {
    saveProjectOfOne();
    edit(4.0);
    window_->close();
    QVERIFY2(window_->isVisible(), "first it asks");
    answer("Save");
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isVisible(), kProjectPatienceMs);
    QCOMPARE(savedFactor("one.cutis"), 4.0);
  }

  void quittingAsksOnceForAll() {
    open("one.png");
    edit(2.0);
    open("two.png");
    edit(2.0);
    window_->close();
    QVERIFY(question() != nullptr);
    QVERIFY(question()->text().contains("one.png and two.png"));
    window_->close();
    QCOMPARE(window_->findChildren<QMessageBox*>().size(), 1);
    QTest::keyClick(question(), Qt::Key_Escape);
    QTRY_VERIFY(question() == nullptr);
    QVERIFY(window_->isVisible());
    window_->close();
    answer("Discard");
    QTRY_VERIFY(!window_->isVisible());
  }

  void quittingWaitsForWhatIsWritten() {
    open("one.png");
    edit(2.0);
    window_->saves().saveTo(file("waited.cutis"));
    window_->close();
    QVERIFY(window_->isVisible());
    answer("Wait and close");
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isVisible(), kProjectPatienceMs);
    QCOMPARE(savedFactor("waited.cutis"), 2.0);
  }

  void aChangedSourceIsOffered() {
    paint("live.png", QColor(190, 140, 120));
    open("live.png");
    edit(2.0);
    paint("live.png", QColor(180, 130, 110));
    window_->document().checkSource();
    NoticeBar& bar = window_->tabs().current().notice();
    QTRY_VERIFY(bar.isVisible());
    QVERIFY(bar.text().contains("live.png has changed on disk"));
    test::pressButton(bar, "Keep");
    QVERIFY(!bar.isVisible());
    paint("live.png", QColor(170, 120, 100));
    window_->document().checkSource();
    QTRY_VERIFY(bar.isVisible());
    test::pressButton(bar, "Reload");
    waitUntilIdle();
    QVERIFY(!bar.isVisible());
    QCOMPARE(window_->document().scene().edits.front().parameters[kMelanin].scale, 2.0);
    QVERIFY(window_->isWindowModified());
  }

  // While the window is used.
  void aChangeIsNoticedWithoutLeavingTheWindow() {
    paint("watched.png", QColor(190, 140, 120));
    open("watched.png");
    activate();
    paint("watched.png", QColor(180, 130, 110));
    NoticeBar& bar = window_->tabs().current().notice();
    QTRY_VERIFY_WITH_TIMEOUT(bar.isVisible(), 8000);
    test::pressButton(bar, "Keep");
    fs::remove(folder_ / "watched.png");
    QTRY_VERIFY_WITH_TIMEOUT(window_->progress().message().contains("watched.png is no longer"),
                             12000);
    window_->progress().clearMessages();
    QTest::qWait(5000);
    QVERIFY2(window_->progress().message().isEmpty(), "once");
  }

  void aMissingSourceIsAskedFor() {
    saveProjectOfOne();
    restart();
    fs::create_directory(folder_ / "moved");
    fs::rename(folder_ / "one.png", folder_ / "moved/one.png");
    window_->opener().open(file("one.cutis"));
    QTRY_VERIFY_WITH_TIMEOUT(question() != nullptr, kProjectPatienceMs);
    QVERIFY(question()->text().contains("one.cutis needs one.png"));
    QVERIFY(question()->informativeText().startsWith("It was in the project's folder."));
    QVERIFY(question()->windowTitle().contains("needs one.png"));
    chooseInDialog(file("moved/one.png"));
    answer("Choose the file…");
    QTRY_VERIFY_WITH_TIMEOUT(window_->document().isOpen(), kProjectPatienceMs);
    waitUntilIdle();
    fs::rename(folder_ / "moved/one.png", folder_ / "one.png");
    QVERIFY(window_->document().isOpen());
    QCOMPARE(window_->document().scene().edits.front().parameters[kMelanin].scale, 2.0);
    QVERIFY2(window_->isWindowModified(), "the project does not know the new place yet");
  }

  void anotherSourceIsTakenOnlyWhenSaidSo() {
    saveProjectOfOne();
    restart();
    fs::rename(folder_ / "one.png", folder_ / "hidden.png");
    window_->opener().open(file("one.cutis"));
    QTRY_VERIFY_WITH_TIMEOUT(question() != nullptr, kProjectPatienceMs);
    chooseInDialog(file("two.png"));
    answer("Choose the file…");
    QTRY_VERIFY_WITH_TIMEOUT(question() != nullptr, kProjectPatienceMs);
    QVERIFY(question()->text().contains("two.png is not the file"));
    answer("Use it");
    waitUntilIdle();
    fs::rename(folder_ / "hidden.png", folder_ / "one.png");
    QVERIFY(window_->document().isOpen());
    QVERIFY(window_->progress().message().contains("two.png"));
  }

  void whatACrashLeftIsOfferedOnce() {
    saveProjectOfOne();
    leaveJournal();
    restart();
    window_->keepJournals(folder_ / "journals");
    QVERIFY(question() != nullptr);
    QVERIFY(question()->informativeText().contains("one.png (today "));
    answer("Bring back");
    QTRY_VERIFY_WITH_TIMEOUT(window_->document().isOpen(), kProjectPatienceMs);
    waitUntilIdle();
    QVERIFY(window_->isWindowModified());
    QVERIFY(window_->document().projectPath().empty());
    QCOMPARE(window_->document().scene().edits.front().parameters[kMelanin].scale, 2.0);
    window_->commands().run("file.close");
    answer("Discard");
    QTRY_VERIFY(!window_->document().isOpen());
    restart();
    window_->keepJournals(folder_ / "journals");
    QVERIFY2(question() == nullptr, "once");
  }

  void whoeverTurnsAwayGetsTheEditsBack() {
    saveProjectOfOne();
    leaveJournal();
    restart();
    window_->keepJournals(folder_ / "journals");
    QTest::keyClick(question(), Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(window_->document().isOpen(), kProjectPatienceMs);
    waitUntilIdle();
    QVERIFY(window_->isWindowModified());
    window_->commands().run("file.close");
    answer("Discard");
    QTRY_VERIFY(!window_->document().isOpen());
  }

  void discardedJournalsAreGone() {
    saveProjectOfOne();
    leaveJournal();
    restart();
    window_->keepJournals(folder_ / "journals");
    answer("Discard");
    restart();
    window_->keepJournals(folder_ / "journals");
    QVERIFY(question() == nullptr);
  }

  // And is seen when it is back.
  void editsOfAProjectAreOfferedByItsName() {
    saveProjectOfOne();
    window_->keepJournals(folder_ / "journals");
    window_->views().show(ViewKind::photograph);
    edit(2.5);
    restart();
    window_->keepJournals(folder_ / "journals");
    QVERIFY(question() != nullptr);
    QVERIFY2(question()->informativeText().contains("one.cutis (today "),
             qPrintable(question()->informativeText()));
    answer("Bring back");
    QTRY_VERIFY_WITH_TIMEOUT(window_->document().isOpen(), kProjectPatienceMs);
    waitUntilIdle();
    QVERIFY(window_->views().current() != ViewKind::photograph);
    window_->commands().run("file.close");
    answer("Discard");
    QTRY_VERIFY(!window_->document().isOpen());
  }

  // What closes without a question, as a system that shuts down does, has its edits in the journal.
  void whatEndsWithoutAQuestionIsOffered() {
    window_->keepJournals(folder_ / "journals");
    open("one.png");
    edit(2.0);
    restart();
    window_->keepJournals(folder_ / "journals");
    QVERIFY(question() != nullptr);
    answer("Discard");
  }

  // The small pictures of what was opened, in the cache, until private data are cleared.
  void recentFilesHaveThumbnails() {
    open("one.png");
    const fs::path kept = cacheFolder() / "thumbnails";
    QTRY_VERIFY(fs::exists(kept) && !fs::is_empty(kept));
    window_->saves().saveTo(file("thumbs.cutis"));
    waitUntilIdle();
    QTRY_COMPARE(std::distance(fs::directory_iterator(kept), {}), 2);
    QMenu* recent = recentMenu();
    QVERIFY(recent != nullptr);
    Q_EMIT recent->aboutToShow();
    QTRY_VERIFY(!recent->actions()[0]->icon().isNull());
    clearPrivateData();
    QVERIFY(!fs::exists(kept));
  }

  void recentFilesAreAtHandAndForgotten() {
    open("one.png");
    open("two.png");
    QMenu* recent = recentMenu();
    QVERIFY(recent != nullptr);
    Q_EMIT recent->aboutToShow();
    QVERIFY(recent->actions()[0]->text().contains("two.png"));
    QVERIFY(recent->actions()[1]->text().contains("one.png"));
    recent->actions()[1]->trigger();
    waitUntilIdle();
    QVERIFY(window_->windowTitle().contains("one.png"));
    recent->actions().last()->trigger();
    Q_EMIT recent->aboutToShow();
    QVERIFY(!recent->actions()[0]->isEnabled());
  }

 private:
  void setUp() override {
    QSettings().clear();
    makeWindow();
  }
  void tearDown() override { window_.reset(); }
  void makeWindow() {
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->resize(1280, 900);
    window_->show();
  }
  void restart() {
    window_.reset();
    makeWindow();
  }

  QString file(const std::string& name) const {
    return QString::fromStdString((folder_ / name).string());
  }
  void paint(const std::string& name, const QColor& color) {
    QImage image(40, 30, QImage::Format_RGB32);
    image.fill(color);
    QVERIFY(image.save(file(name)));
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kProjectPatienceMs);
  }
  void open(const std::string& name) {
    window_->opener().open(file(name));
    waitUntilIdle();
  }
  void edit(double factor) { window_->edits().setFactor(kMelanin, factor, false); }
  void activate() {
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  }
  void saveProjectOfOne() {
    open("one.png");
    edit(2.0);
    window_->views().show(ViewKind::melanin);
    window_->viewport().showPlace({20.0, 15.0}, 20.0);
    window_->saves().saveTo(file("one.cutis"));
    waitUntilIdle();
    QVERIFY(!window_->isWindowModified());
  }
  double savedFactor(const std::string& name) const {
    const auto project = readProject(folder_ / name, {});
    if (!project || project.value().edits.empty()) return 0.0;
    return project.value().edits.front().parameters[kMelanin].scale;
  }
  // As a process that was killed leaves it.
  void leaveJournal() {
    const auto project = readProject(folder_ / "one.cutis", {});
    QVERIFY(bool(project));
    Project kept = project.value();
    kept.maps.clear();
    folder_.write("journals/0123-0.cutis", projectText(kept, {}));
    folder_.write("journals/0123.lock",
                  "4194304\ntest_ui\n" + QSysInfo::machineHostName().toStdString() + "\n");
  }

  QMessageBox* question() const { return test::questionBefore(*window_); }
  void answer(const QString& text) { test::answerQuestion(*window_, text); }
  void chooseInDialog(const QString& path) { test::chooseInNextDialog(*window_, path); }
  QMenu* recentMenu() const {
    for (QMenu* menu : window_->findChildren<QMenu*>()) {
      if (menu->title() == "Open &recent") return menu;
    }
    return nullptr;
  }

  test::ScratchFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(ProjectWindowTest)

}  // namespace
}  // namespace cutis

#include "project_window_test.moc"
