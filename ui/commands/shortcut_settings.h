#pragma once

// The shortcuts that people have chosen themselves, kept in the settings. Each belongs to one
// command. Interface thread only.

#include <QKeySequence>
#include <QString>

namespace cutis {

class CommandRegistry;

class ShortcutSettings {
 public:
  // The registry outlives it.
  explicit ShortcutSettings(CommandRegistry& commands) : commands_(commands) {}

  // Gives every command the shortcuts that were kept. Call once, when all commands are there. One
  // that two commands would have goes to the one that it was chosen for.
  void restore();

  // The command's only shortcut from now on; empty: it has none. Returns one sentence that says
  // why not, where it belongs to another command or to the controls; then nothing has changed.
  // Precondition of these: there is such a command.
  QString choose(const QString& id, const QKeySequence& keys);
  // As the table says. Returns an objection as choose() does.
  QString reset(const QString& id);
  void resetAll();
  // Whether it is as the table says.
  bool isUsual(const QString& id) const;

 private:
  QString objectionTo(const QString& id, const QKeySequence& keys) const;

  CommandRegistry& commands_;
};

}  // namespace cutis
