#pragma once

// One row of the table of commands: what a command is called, where it stands, what it does, and
// why it cannot be done now.

#include <functional>

#include <QKeySequence>
#include <QList>
#include <QString>

namespace cutis {

// The menus of the menu bar, in its order.
enum class Menu { file, edit, view, fit, help };

struct CommandDescription {
  QString id;  // "edit.undo": in scripts and settings, never shown
  Menu menu = Menu::file;
  QString submenu = {};  // of the menu, by its title with its mnemonic; empty: the menu itself
  QString text;          // as in the menu, with its mnemonic: "&Undo"
  QString toolTip = {};  // what the text leaves open; may be empty
  // They work in the whole window; single letters do not while text is being typed.
  QList<QKeySequence> shortcuts = {};
  bool beginsSection = false;  // a line stands above it in the menu

  std::function<void()> run;
  // One sentence that says why the command cannot run now; empty if it can. Without it, it always
  // can.
  std::function<QString()> objection = {};
  // Takes the place of `text` where that depends on what is open.
  std::function<QString()> textNow = {};
  // For commands that switch something on and off: whether it is on.
  std::function<bool()> isOn = {};
  // One of the commands of a group is on at a time; empty: none excludes another.
  QString exclusiveGroup = {};
};

}  // namespace cutis
