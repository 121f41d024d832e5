#include "ui/commands/command_registry.h"

#include <QAction>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

class CommandRegistryTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void aCommandRunsByItsShortcut() {
    Window w;
    w.commands.add({row("a.one", {QKeySequence("Ctrl+1")}, [&] { ++runs_; })});
    QTest::keyClick(&w.window, Qt::Key_1, Qt::ControlModifier);
    QCOMPARE(runs_, 1);
  }

  void anObjectionDisablesAndSaysWhy() {
    Window w;
    QString why = "Nothing is open yet";
    CommandDescription command = row("a.one", {QKeySequence("Ctrl+1")}, [&] { ++runs_; });
    command.objection = [&] { return why; };
    command.toolTip = "What it does";
    w.commands.add({command});
    QAction* action = w.commands.action("a.one");
    QVERIFY(!action->isEnabled());
    QCOMPARE(action->toolTip(), why);
    QTest::keyClick(&w.window, Qt::Key_1, Qt::ControlModifier);
    QCOMPARE(w.commands.run("a.one"), why);
    QCOMPARE(runs_, 0);

    why.clear();
    w.commands.refresh();
    QVERIFY(action->isEnabled());
    QCOMPARE(action->toolTip(), QString("What it does"));
    QVERIFY(w.commands.run("a.one").isEmpty());
    QCOMPARE(runs_, 1);
  }

  // Whatever a command changes is seen to, also in the others.
  void textAndCheckFollow() {
    Window w;
    bool on = false;
    CommandDescription command = row("a.one", {}, [&] { on = !on; });
    command.isOn = [&] { return on; };
    CommandDescription other = row("a.other", {}, [] {});
    other.textNow = [&] { return QString(on ? "On" : "Off"); };
    w.commands.add({command, other});
    QCOMPARE(w.commands.action("a.other")->text(), QString("Off"));
    w.commands.action("a.one")->trigger();
    QVERIFY(w.commands.action("a.one")->isChecked());
    QCOMPARE(w.commands.action("a.other")->text(), QString("On"));
  }

  // Whatever has the keyboard, unless text is being typed.
  void aLetterWorksUnlessTextIsTyped() {
    Window w;
    QPushButton button(&w.window);
    QLineEdit field(&w.window);
    for (QWidget* widget : {static_cast<QWidget*>(&button), static_cast<QWidget*>(&field)})
      widget->show();
    w.commands.add({row("a.fit", {QKeySequence(Qt::Key_F)}, [&] { ++runs_; })});
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_F);
    QCOMPARE(runs_, 0);
    QCOMPARE(field.text(), QString("f"));
    button.setFocus();
    QTest::keyClick(&button, Qt::Key_F);
    QCOMPARE(runs_, 1);
  }

  void menusHoldTheRowsInOrder() {
    Window w;
    CommandDescription first = row("file.first", {}, [] {});
    CommandDescription second = row("file.second", {}, [] {});
    second.beginsSection = true;
    CommandDescription view = row("view.one", {}, [] {});
    view.menu = Menu::view;
    w.commands.add({first, view, second});
    w.commands.fill(*w.window.menuBar());
    const auto file = w.window.menuBar()->actions().first()->menu()->actions();
    QCOMPARE(file.size(), 3);
    QCOMPARE(file[0], w.commands.action("file.first"));
    QVERIFY(file[1]->isSeparator());
    QCOMPARE(file[2], w.commands.action("file.second"));
    QVERIFY(w.commands.action("no.such") == nullptr);
  }

 private:
  struct Window {
    Window() {
      window.show();
      window.activateWindow();
      static_cast<void>(QTest::qWaitForWindowActive(&window));
    }
    QMainWindow window;
    CommandRegistry& commands = *new CommandRegistry(window);
  };

  static CommandDescription row(const QString& id, const QList<QKeySequence>& shortcuts,
                                std::function<void()> run) {
    CommandDescription command;
    command.id = id;
    command.text = id;
    command.shortcuts = shortcuts;
    command.run = std::move(run);
    return command;
  }

  void setUp() override { runs_ = 0; }

  int runs_ = 0;
};

CUTIS_TEST(CommandRegistryTest)

}  // namespace
}  // namespace cutis

#include "command_registry_test.moc"
