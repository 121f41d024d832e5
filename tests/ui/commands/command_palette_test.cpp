// Commands by their names, on a table made here.

#include "ui/commands/command_palette.h"

#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMenu>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/commands/command_registry.h"
#include "ui/commands/command_search.h"
#include "ui/commands/context_menu.h"

namespace cutis {
namespace {

class CommandPaletteTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void wordsAreFoundInAnyOrder() {
    QVERIFY(matchQuality("albedo export", "Export edited albedo…", "File") > 0);
    QVERIFY(matchQuality("EXP ALB", "Export edited albedo…", "File") > 0);
    QVERIFY(matchQuality("albedo import", "Export edited albedo…", "File") == 0);
    QVERIFY(matchQuality("carotenemie", "Caroténémie", "") > 0);
    QVERIFY(matchQuality("xpalb", "Export edited albedo…", "File") == 0);
    QVERIFY(matchQuality("expalb", "Export edited albedo…", "File") > 0);
    QVERIFY(matchQuality("", "Anything", "") > 0);
  }

  void betterOnesStandFirst() {
    const int begins = matchQuality("fit", "Fit again", "Fit");
    const int within = matchQuality("fit", "Refit", "Fit");
    const int about = matchQuality("fit", "Train a network…", "Fit");
    QVERIFY(begins > within && within > about && about > 0);
  }

  void typingFiltersAndEnterRuns() {
    open();
    QCOMPARE(list_->count(), 3);
    QTest::keyClicks(query_, "alb exp");
    QCOMPARE(list_->count(), 1);
    QCOMPARE(list_->item(0)->text(), QString("Export edited albedo…"));
    QTest::keyClick(query_, Qt::Key_Return);
    QCOMPARE(ran_, QStringList{"file.export"});
    QVERIFY(!palette_->isVisible());
    QVERIFY(field_->hasFocus());
  }

  void arrowsChooseAndAClickRuns() {
    open();
    QTest::keyClick(query_, Qt::Key_Down);
    QCOMPARE(list_->currentRow(), 1);
    QTest::keyClick(query_, Qt::Key_Up);
    QTest::keyClick(query_, Qt::Key_Up);
    QCOMPARE(list_->currentRow(), 0);
    QTest::mouseClick(list_->viewport(), Qt::LeftButton, {},
                      list_->visualItemRect(list_->item(2)).center());
    QCOMPARE(ran_, QStringList{"view.whole"});
  }

  // It stays, with its reason.
  void whatCannotRunSaysWhy() {
    open();
    QTest::keyClicks(query_, "undo");
    QCOMPARE(list_->item(0)->data(Qt::AccessibleDescriptionRole).toString(),
             QString("There is nothing to undo"));
    QTest::keyClick(query_, Qt::Key_Return);
    QVERIFY(palette_->isVisible());
    QVERIFY(ran_.isEmpty());
    QTest::keyClick(query_, Qt::Key_Escape);
    QVERIFY(!palette_->isVisible());
    QVERIFY(field_->hasFocus());
  }

  void nothingFoundIsSaid() {
    open();
    QTest::keyClicks(query_, "qqq");
    QVERIFY(!list_->isVisible());
    QTest::keyClick(query_, Qt::Key_Return);
    QVERIFY(palette_->isVisible() && ran_.isEmpty());
    QTest::keyClick(query_, Qt::Key_Escape);
  }

  void itGoesWhenSomethingElseHasTheKeyboard() {
    open();
    field_->setFocus();
    QVERIFY(!palette_->isVisible());
  }

  void itStaysWithinASmallWindow() {
    window_->resize(420, 320);
    open();
    QVERIFY(window_->rect().contains(palette_->geometry()));
    QTest::keyClick(query_, Qt::Key_Escape);
  }

  void theRightButtonOffersCommands() {
    giveContextMenu(*field_, *commands_, {"view.whole", "", "edit.undo", "no.such"});
    QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, field_->mapToGlobal(QPoint(5, 5)));
    QApplication::sendEvent(field_, &event);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QVERIFY(menu != nullptr);
    QCOMPARE(menu->actions().size(), 3);
    QVERIFY(!menu->actions()[2]->isEnabled());
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(menu->actions()[0]).center());
    QTRY_COMPARE(ran_, QStringList{"view.whole"});
  }

 private:
  void setUp() override {
    ran_.clear();
    window_ = std::make_unique<QMainWindow>();
    commands_ = new CommandRegistry(*window_);
    field_ = new QLineEdit(window_.get());
    window_->setCentralWidget(field_);
    const auto row = [this](const QString& id, Menu menu, const QString& text) {
      CommandDescription command;
      command.id = id;
      command.menu = menu;
      command.text = text;
      command.run = [this, id] { ran_ << id; };
      return command;
    };
    CommandDescription undo = row("edit.undo", Menu::edit, "&Undo");
    undo.objection = [] { return QString("There is nothing to undo"); };
    commands_->add({row("file.export", Menu::file, "&Export edited albedo…"), undo,
                    row("view.whole", Menu::view, "&Whole picture")});
    palette_ = new CommandPalette(*commands_, *window_);
    query_ = palette_->findChild<QLineEdit*>();
    list_ = palette_->findChild<QListWidget*>();
    window_->resize(900, 700);
    window_->show();
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    field_->setFocus();
  }
  void tearDown() override { window_.reset(); }

  void open() {
    palette_->open();
    QVERIFY(palette_->isVisible() && query_->hasFocus());
  }

  std::unique_ptr<QMainWindow> window_;
  CommandRegistry* commands_ = nullptr;
  QLineEdit* field_ = nullptr;
  CommandPalette* palette_ = nullptr;
  QLineEdit* query_ = nullptr;
  QListWidget* list_ = nullptr;
  QStringList ran_;
};

CUTIS_TEST(CommandPaletteTest)

}  // namespace
}  // namespace cutis

#include "command_palette_test.moc"
