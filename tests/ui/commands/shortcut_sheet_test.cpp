// Shortcuts that people change, on a table made here.

#include "ui/commands/shortcut_sheet.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QSettings>
#include <QTreeWidget>
#include <QtTest>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_registry.h"
#include "ui/commands/key_catcher.h"

namespace cutis {
namespace {

class ShortcutSheetTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() { test::keepSettingsIn(folder_.path()); }

  void commandsStandInTheirMenus() {
    QCOMPARE(tree_->topLevelItemCount(), 2);
    QCOMPARE(tree_->topLevelItem(0)->text(0), QString("Edit"));
    QCOMPARE(rowOf("edit.redo")->text(1), QString("Ctrl+Shift+Z; Ctrl+Y"));
  }

  void searchingHidesTheRest() {
    auto* query = sheet_->findChild<QLineEdit*>();
    QTest::keyClicks(query, "whole");
    QVERIFY(tree_->topLevelItem(0)->isHidden());
    QVERIFY(!rowOf("view.whole")->isHidden());
    query->clear();
    // By its keys.
    QTest::keyClicks(query, "ctrl+y");
    QVERIFY(!rowOf("edit.redo")->isHidden());
    QVERIFY(rowOf("edit.undo")->isHidden());
  }

  void newKeysAreTakenAndKept() {
    press("view.whole", Qt::Key_G, Qt::ControlModifier);
    QCOMPARE(rowOf("view.whole")->text(1), QString("Ctrl+G"));
    QVERIFY(rowOf("view.whole")->font(1).bold());
    sheet_->close();
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    QTest::keyClick(window_.get(), Qt::Key_G, Qt::ControlModifier);
    QCOMPARE(ran_, QStringList{"view.whole"});
    QTest::keyClick(window_.get(), Qt::Key_F);
    QCOMPARE(ran_.size(), 1);
    start();
    QCOMPARE(commands_->action("view.whole")->shortcut(), QKeySequence("Ctrl+G"));
  }

  // Before they would have run the other command, too.
  void keysOfAnotherAreNotTaken() {
    press("view.whole", Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(ran_.isEmpty());
    QVERIFY2(message().contains("Undo"), qPrintable(message()));
    QCOMPARE(commands_->action("view.whole")->shortcut(), QKeySequence(Qt::Key_F));
    // It still waits for other keys.
    QTest::keyClick(catcher(), Qt::Key_Question, Qt::ShiftModifier);
    QCOMPARE(commands_->action("view.whole")->shortcut(), QKeySequence(Qt::Key_Question));
    QTRY_VERIFY(catcher() == nullptr);
  }

  void keysOfControlsAreNotTaken() {
    press("view.whole", Qt::Key_Tab, Qt::NoModifier);
    QVERIFY(message().contains("Tab"));
    QTest::keyClick(catcher(), Qt::Key_Escape);
    QTRY_VERIFY(catcher() == nullptr);
    QCOMPARE(commands_->action("view.whole")->shortcut(), QKeySequence(Qt::Key_F));
    QVERIFY(sheet_->isVisible());
  }

  void backspaceTakesThemAway() {
    press("view.whole", Qt::Key_Backspace, Qt::NoModifier);
    QVERIFY(commands_->action("view.whole")->shortcuts().isEmpty());
    start();
    QVERIFY(commands_->action("view.whole")->shortcuts().isEmpty());
  }

  void oneAndAllAreReset() {
    press("edit.redo", Qt::Key_G, Qt::ControlModifier);
    press("view.whole", Qt::Key_Y, Qt::ControlModifier);
    tree_->setCurrentItem(rowOf("edit.redo"));
    // Its usual keys have gone to another command.
    QTest::mouseClick(button("Reset"), Qt::LeftButton);
    QVERIFY(message().contains("Whole"));
    QCOMPARE(commands_->action("edit.redo")->shortcut(), QKeySequence("Ctrl+G"));
    QTest::mouseClick(button("Reset all"), Qt::LeftButton);
    QCOMPARE(commands_->action("edit.redo")->shortcuts().size(), 2);
    QCOMPARE(commands_->action("view.whole")->shortcut(), QKeySequence(Qt::Key_F));
    QVERIFY(!button("Reset")->isEnabled());
    start();
    QCOMPARE(commands_->action("view.whole")->shortcut(), QKeySequence(Qt::Key_F));
  }

  // Two commands that have changed their keys, and a settings file that somebody has written.
  void keptShortcutsStayUnique() {
    QSettings().setValue("shortcuts/edit.undo", QStringList{"F"});
    QSettings().setValue("shortcuts/view.whole", QStringList{"Ctrl+Z"});
    start();
    QCOMPARE(commands_->action("edit.undo")->shortcut(), QKeySequence(Qt::Key_F));
    QCOMPARE(commands_->action("view.whole")->shortcut(), QKeySequence("Ctrl+Z"));
    QSettings().setValue("shortcuts/view.whole", QStringList{"F"});
    start();
    QVERIFY(commands_->action("view.whole")->shortcuts().isEmpty());
  }

 private:
  void setUp() override {
    QSettings().clear();
    start();
  }
  void tearDown() override { window_.reset(); }

  void start() {
    ran_.clear();
    window_ = std::make_unique<QMainWindow>();
    commands_ = new CommandRegistry(*window_);
    const auto row = [this](const QString& id, Menu menu, const QString& text,
                            const QList<QKeySequence>& keys) {
      CommandDescription command;
      command.id = id;
      command.menu = menu;
      command.text = text;
      command.shortcuts = keys;
      command.run = [this, id] { ran_ << id; };
      return command;
    };
    commands_->add({row("edit.undo", Menu::edit, "&Undo", {QKeySequence("Ctrl+Z")}),
                    row("edit.redo", Menu::edit, "&Redo",
                        {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")}),
                    row("view.whole", Menu::view, "&Whole picture", {QKeySequence(Qt::Key_F)})});
    ShortcutSettings(*commands_).restore();
    sheet_ = new ShortcutSheet(*commands_, *window_);
    window_->resize(900, 700);
    window_->show();
    sheet_->open();
    QVERIFY(QTest::qWaitForWindowActive(sheet_));
    tree_ = sheet_->findChild<QTreeWidget*>();
  }

  QTreeWidgetItem* rowOf(const QString& id) const {
    for (QTreeWidgetItemIterator at(tree_); *at != nullptr; ++at) {
      if ((*at)->data(0, Qt::UserRole).toString() == id) return *at;
    }
    return nullptr;
  }
  QPushButton* button(const QString& text) const {
    for (QPushButton* candidate : sheet_->findChildren<QPushButton*>()) {
      if (candidate->text() == text) return candidate;
    }
    return nullptr;
  }
  QString message() const {
    QString all;
    for (const QLabel* label : sheet_->findChildren<QLabel*>())
      all += label->text();
    return all;
  }
  KeyCatcher* catcher() const {
    for (KeyCatcher* found : sheet_->findChildren<KeyCatcher*>()) {
      if (found->isVisible()) return found;
    }
    return nullptr;
  }
  void press(const QString& id, Qt::Key key, Qt::KeyboardModifiers modifiers) {
    const QPoint place = tree_->visualItemRect(rowOf(id)).center();
    QTest::mouseClick(tree_->viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(tree_->viewport(), Qt::LeftButton, {}, place);
    QTRY_VERIFY(catcher() != nullptr && catcher()->hasFocus());
    QTest::keyClick(catcher(), key, modifiers);
  }

  test::ScratchFolder folder_;
  std::unique_ptr<QMainWindow> window_;
  CommandRegistry* commands_ = nullptr;
  ShortcutSheet* sheet_ = nullptr;
  QTreeWidget* tree_ = nullptr;
  QStringList ran_;
};

CUTIS_TEST(ShortcutSheetTest)

}  // namespace
}  // namespace cutis

#include "shortcut_sheet_test.moc"
