#pragma once

// All commands of the editor. Menus, shortcuts, palette and scripts come from here, so that a
// command that is added to the table is found everywhere. Interface thread only.

#include <map>
#include <vector>

#include <QObject>

#include "ui/commands/command_description.h"

class QAction;
class QActionGroup;
class QMenuBar;

namespace cutis {

class CommandRegistry : public QObject {
  Q_OBJECT

 public:
  // Shortcuts work in `window`, which outlives the registry.
  explicit CommandRegistry(QWidget& window);

  // Adds rows to the end of the table. Preconditions: each id is new, each shortcut free, and
  // `run` is there.
  void add(const std::vector<CommandDescription>& commands);
  const std::vector<CommandDescription>& all() const { return commands_; }

  // "Edit", "View › Docks": where a command stands, without mnemonics.
  static QString placeOf(const CommandDescription& command);
  // What a command is called now, without its mnemonic: "Undo Melanin × 1.4".
  QString nameOf(const CommandDescription& command) const;

  // Null if there is no such command.
  QAction* action(const QString& id) const;
  // Runs the command unless there is an objection to it, which is returned; empty if it has run.
  // Precondition: there is such a command.
  QString run(const QString& id);

  // Adds the menus, with every command in them.
  void fill(QMenuBar& bar) const;

  // Asks all commands again what they are called, whether they can run and whether they are on.
  // Call it when what they depend on has changed; whatever a command itself changes is seen to.
  void refresh();

 private:
  struct Entry {
    std::size_t row;
    QAction* action;
  };

  void addAction(const CommandDescription& command);
  QActionGroup& groupOf(const QString& name);
  static void refresh(const CommandDescription& command, QAction& action);

  QWidget& window_;
  std::vector<CommandDescription> commands_;
  std::map<QString, Entry> entries_;  // by id
  std::map<QString, QActionGroup*> groups_;
};

}  // namespace cutis
