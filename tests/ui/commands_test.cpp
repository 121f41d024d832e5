// The editor's tables of commands and docks, by keys and menus, on the embedded sample.

#include <memory>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTimer>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_palette.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_controller.h"
#include "ui/dialogs/training_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/workspace.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/spectrum/pin_controller.h"
#include "ui/spectrum/reference_curves.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/widgets/factor_field.h"
#include "ui/widgets/neutral_slider.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kCommandPatienceMs = 120000;
// Commands of another document, or of none; see DocumentTabsTest. Those of files are not for the
// sample; see MaskWindowTest; nor is there anything to cancel, to fit again or to compare
// with.
const QStringList kLeavingCommands = {
    "file.quit",        "file.close",      "view.nextDocument", "view.previousDocument",
    "file.interpretAs", "file.chooseMask", "file.removeMask",   "edit.cancelJob",
    "fit.again",        "compare.kept"};
// Of more lights than the sample has, and of what its fit does not find.
const QStringList kOtherViews = {
    "view.shading", "view.oxygenation", "view.thickness", "view.light4", "view.light5",
    "view.light6",  "view.light7",      "view.light8",    "view.light9", "view.light10"};

class CommandsTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() { test::keepSettingsIn(folder_.path()); }

  void idsAndShortcutsAreUnique() {
    QStringList ids, shortcuts;
    for (const CommandDescription& command : window_->commands().all()) {
      ids << command.id;
      for (const QKeySequence& keys : command.shortcuts)
        shortcuts << keys.toString();
    }
    QVERIFY(ids.size() > 20);
    QCOMPARE(ids.removeDuplicates(), 0);
    QCOMPARE(shortcuts.removeDuplicates(), 0);
  }

  void everyCommandIsInOneMenuAndHasAShortcut() {
    QList<QAction*> inMenus;
    for (const QAction* menu : window_->menuBar()->actions())
      inMenus << actionsOf(*menu->menu());
    for (const CommandDescription& command : window_->commands().all()) {
      const QAction* action = window_->commands().action(command.id);
      QVERIFY2(inMenus.count(action) == 1, qPrintable(command.id));
      QVERIFY2(!command.shortcuts.isEmpty(), qPrintable(command.id));
      QVERIFY2(!command.shortcuts.first().isEmpty(), qPrintable(command.id));
    }
  }

  // They stand together, each with a letter of its own.
  void docksHaveASubmenu() {
    QStringList letters;
    for (const DockDescription& dock : window_->workspace().all()) {
      const QString text = window_->commands().action("dock." + dock.id)->text();
      const auto place = text.indexOf('&');
      QVERIFY2(place >= 0, qPrintable(text));
      letters << text.mid(place + 1, 1).toLower();
      QVERIFY(!window_->workspace().dock(dock.id)->windowTitle().contains('&'));
    }
    QCOMPARE(letters.removeDuplicates(), 0);
  }

  void everyDockHasItsCommand() {
    for (const DockDescription& dock : window_->workspace().all()) {
      const QAction* action = window_->commands().action("dock." + dock.id);
      QVERIFY2(action != nullptr, qPrintable(dock.id));
      QCOMPARE(action->shortcut(), dock.shortcut);
    }
  }

  // And nothing else can be done.
  void whileNothingIsOpenCommandsSayWhy() {
    const QStringList always = {"file.openSample",  "file.openCapture",     "file.openImage",
                                "file.openImageAs", "file.openPhotographs", "file.clearPrivateData",
                                "file.quit",        "help.palette",         "help.shortcuts",
                                "help.about"};
    for (const CommandDescription& command : window_->commands().all()) {
      const QAction* action = window_->commands().action(command.id);
      QVERIFY2(action->isEnabled() == always.contains(command.id), qPrintable(command.id));
      QVERIFY2(action->isEnabled() || action->toolTip() == command.objection(),
               qPrintable(command.id));
    }
  }

  void everyShortcutRunsItsCommand() {
    openSample();
    QTimer closer;  // of the dialogs that commands open
    connect(&closer, &QTimer::timeout, [] {
      if (QWidget* dialog = QApplication::activeModalWidget()) dialog->close();
    });
    closer.start(50);
    for (const CommandDescription& command : window_->commands().all()) {
      if (kLeavingCommands.contains(command.id) || kOtherViews.contains(command.id)) continue;
      for (const QKeySequence& keys : command.shortcuts) {
        prepare();
        QSignalSpy run(window_->commands().action(command.id), &QAction::triggered);
        QTest::keySequence(&window_->viewport(), keys);
        QVERIFY2(run.count() == 1, qPrintable(command.id + " by " + keys.toString()));
        window_->training().stop();
        waitUntilIdle();
      }
    }
  }

  void quittingClosesTheWindow() {
    activate();
    QTest::keyClick(window_.get(), Qt::Key_Q, Qt::ControlModifier);
    QVERIFY(!window_->isVisible());
  }

  void thePictureKeepsItsLetters() {
    openSample();
    Viewport& viewport = window_->viewport();
    QTest::keyClick(&viewport, Qt::Key_1);
    QCOMPARE(viewport.zoom(), 1.0);
    QTest::keyClick(&viewport, Qt::Key_Plus);
    QVERIFY(viewport.zoom() > 1.0);
    QTest::keyClick(&viewport, Qt::Key_F);
    QVERIFY(viewport.fitted());
    // In a field they are typed.
    QTest::keyClick(&viewport, Qt::Key_1);
    auto* number = window_->findChild<FactorField*>();
    QVERIFY(number != nullptr);
    number->setFocus();
    number->clear();
    QTest::keyClick(number, Qt::Key_Plus);
    QTest::keyClick(number, Qt::Key_F);
    QCOMPARE(viewport.zoom(), 1.0);
    QCOMPARE(number->text(), QString("+f"));
    QTest::keyClick(number, Qt::Key_Escape);
    // Once the number is taken, they are the picture's again.
    QTest::keyClicks(number, "1.2");
    QTest::keyClick(number, Qt::Key_Return);
    QVERIFY(number->hasFocus());
    QTest::keyClick(number, Qt::Key_F);
    QVERIFY(viewport.fitted());
    QCOMPARE(number->number(), 1.2);
    QTest::keyClick(&viewport, Qt::Key_1);
    // Elsewhere they are not: on a slider and in a list of choices.
    for (QWidget* control : {static_cast<QWidget*>(window_->findChild<NeutralSlider*>()),
                             static_cast<QWidget*>(window_->findChild<QComboBox*>())}) {
      control->setFocus();
      QTest::keyClick(control, Qt::Key_F);
      QVERIFY(viewport.fitted());
      QTest::keyClick(control, Qt::Key_1);
      QCOMPARE(viewport.zoom(), 1.0);
    }
  }

  void textsFollowWhatCanBeUndone() {
    openSample();
    window_->edits().setFactor(kMelanin, 1.4, false);
    const QAction* undo = window_->commands().action("edit.undo");
    QVERIFY(undo->text().contains("Melanin"));
    QVERIFY(window_->commands().run("edit.undo").isEmpty());
    QVERIFY(!undo->isEnabled());
    QCOMPARE(undo->toolTip(), window_->commands().run("edit.undo"));
  }

  void theLayoutIsRemembered() {
    openSample();
    window_->workspace().dock("spectrum")->setFloating(true);
    window_->commands().run("dock.views");
    window_->close();
    restart();
    openSample();
    QVERIFY(window_->workspace().dock("spectrum")->isFloating());
    QVERIFY(window_->workspace().dock("views")->isHidden());
    QVERIFY(!window_->commands().action("dock.views")->isChecked());
    QVERIFY(window_->commands().run("dock.resetLayout").isEmpty());
    QVERIFY(!window_->workspace().dock("spectrum")->isFloating());
    QTRY_VERIFY(window_->commands().action("dock.views")->isChecked());
  }

  // Closed before anything was opened.
  void aLayoutOutlivesARunWithoutDocument() {
    openSample();
    window_->commands().run("dock.light");
    window_->close();
    restart();
    window_->close();
    restart();
    openSample();
    QVERIFY(window_->workspace().dock("light")->isHidden());
  }

  void aBrokenLayoutIsIgnored() {
    QSettings().setValue("layout", QByteArray(500, '\x7f'));
    QSettings().setValue("geometry", QByteArray(500, '\x7f'));
    restart();
    openSample();
    for (const DockDescription& dock : window_->workspace().all())
      QVERIFY2(window_->workspace().dock(dock.id)->isHidden() == !dock.shownAtFirst,
               qPrintable(dock.id));
  }

  // Found, run, and gone again.
  void thePaletteRunsACommand() {
    openSample();
    activate();
    window_->commands().run("view.oneToOne");
    QTest::keyClick(&window_->viewport(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    auto* palette = window_->findChild<CommandPalette*>();
    QVERIFY(palette->isVisible());
    QWidget* query = QApplication::focusWidget();
    QTest::keyClicks(query, "pict whole");
    QTest::keyClick(query, Qt::Key_Return);
    QVERIFY(!palette->isVisible());
    QVERIFY(window_->viewport().fitted());
    QVERIFY(window_->viewport().hasFocus());
  }

  void thePresetsAreBelowTheSliders() {
    openSample();
    QPushButton* button = nullptr;
    for (QPushButton* found : window_->findChildren<QPushButton*>()) {
      if (found->text() == "Presets") button = found;
    }
    QVERIFY(button != nullptr && button->menu() != nullptr);
    Q_EMIT button->menu()->aboutToShow();
    QCOMPARE(button->menu()->actions().first()->text(), QString("Tan"));
    button->menu()->actions().first()->trigger();
    QVERIFY(!isNeutral(window_->document().scene().edits));
    QCOMPARE(window_->document().history().position(), std::size_t{1});
  }

  // Tab reaches whatever can be used, in each dock from top to bottom.
  void theKeyboardReachesEveryControl() {
    openSample();
    activate();
    window_->viewport().setFocus();
    QSet<QWidget*> reached;
    for (QWidget* at = QApplication::focusWidget(); at != nullptr && !reached.contains(at);
         at = QApplication::focusWidget()) {
      reached << at;
      QTest::keyClick(at, Qt::Key_Tab);
    }
    for (QWidget* control : window_->findChildren<QWidget*>()) {
      const bool isControl = qobject_cast<FactorField*>(control) ||
                             qobject_cast<NeutralSlider*>(control) ||
                             qobject_cast<QComboBox*>(control) || qobject_cast<QCheckBox*>(control);
      if (!isControl || !control->isEnabled() || control->visibleRegion().isEmpty()) continue;
      QVERIFY2(reached.contains(control), qPrintable(control->accessibleName()));
    }
  }

 private:
  void setUp() override {
    QSettings().clear();
    restart();
  }
  void tearDown() override { window_.reset(); }

  static QList<QAction*> actionsOf(const QMenu& menu) {
    QList<QAction*> all;
    for (QAction* action : menu.actions()) {
      if (action->menu()) {
        all << actionsOf(*action->menu());
      } else {
        all << action;
      }
    }
    return all;
  }

  void restart() {
    window_.reset();
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->resize(1280, 900);
    window_->show();
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kCommandPatienceMs);
  }
  void openSample() {
    window_->opener().openSample();
    waitUntilIdle();
    QVERIFY(window_->document().isFitted());
  }
  // Something to undo and something to redo, a pin and a reference spectrum, and the keyboard in
  // the picture.
  void prepare() {
    window_->edits().setFactor(kMelanin, 1.4, false);
    window_->edits().setFactor(kMelanin, 1.6, false);
    window_->document().undo();
    window_->views().show(ViewKind::melanin);
    DocumentPage& page = window_->tabs().current();
    if (window_->document().pins().pins.empty()) page.pins().add(500, 500);
    page.pins().select("A");
    folder_.write("forearm.csv", "wavelength,reflectance\n400,0.2\n500,0.3\n600,0.5\n");
    page.references().add(QString::fromStdString((folder_ / "forearm.csv").string()));
    activate();
    window_->viewport().setFocus();
    waitUntilIdle();
  }
  // A shortcut works in the window that is active, which a dialog was before.
  void activate() {
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  }

  test::ScratchFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(CommandsTest)

}  // namespace
}  // namespace cutis

#include "commands_test.moc"
