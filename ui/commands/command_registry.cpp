#include "ui/commands/command_registry.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

namespace cutis {
namespace {

QString titleOf(Menu menu) {
  switch (menu) {
    case Menu::file:
      return CommandRegistry::tr("&File");
    case Menu::edit:
      return CommandRegistry::tr("&Edit");
    case Menu::view:
      return CommandRegistry::tr("&View");
    case Menu::fit:
      return CommandRegistry::tr("Fi&t");
    case Menu::help:
      return CommandRegistry::tr("&Help");
  }
  return {};
}

// Made where its first row stands.
QMenu& submenuOf(QMenu& menu, const QString& title) {
  if (title.isEmpty()) return menu;
  for (const QAction* action : menu.actions()) {
    if (action->menu() && action->menu()->title() == title) return *action->menu();
  }
  QMenu* submenu = menu.addMenu(title);
  submenu->setToolTipsVisible(true);
  return *submenu;
}

// "Save && close" is called "Save & close".
QString withoutMnemonics(QString text) {
  text.replace("&&", QChar(0));
  text.remove('&');
  return text.replace(QChar(0), '&');
}

QString objectionTo(const CommandDescription& command) {
  return command.objection ? command.objection() : QString();
}

}  // namespace

CommandRegistry::CommandRegistry(QWidget& window) : QObject(&window), window_(window) {}

void CommandRegistry::add(const std::vector<CommandDescription>& commands) {
  for (const CommandDescription& command : commands) {
    Q_ASSERT(command.run && !entries_.contains(command.id));
    commands_.push_back(command);
    addAction(command);
  }
}

void CommandRegistry::addAction(const CommandDescription& command) {
  auto* action = new QAction(command.text, this);
  action->setObjectName(command.id);
  action->setShortcuts(command.shortcuts);
  action->setCheckable(command.isOn != nullptr);
  // A key that is held does not switch something on and off all the time.
  action->setAutoRepeat(command.isOn == nullptr);
  if (!command.exclusiveGroup.isEmpty()) groupOf(command.exclusiveGroup).addAction(action);
  // Menus of other systems would guess a place from the text: "About …", "Quit".
  action->setMenuRole(QAction::NoRole);
  window_.addAction(action);
  connect(action, &QAction::triggered, this, [this, id = command.id] { run(id); });
  entries_[command.id] = {commands_.size() - 1, action};
  refresh(command, *action);
}

// One may be on, and none is while nothing is open.
QActionGroup& CommandRegistry::groupOf(const QString& name) {
  QActionGroup*& group = groups_[name];
  if (group == nullptr) {
    group = new QActionGroup(this);
    group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  }
  return *group;
}

QString CommandRegistry::placeOf(const CommandDescription& command) {
  const QString menu = withoutMnemonics(titleOf(command.menu));
  if (command.submenu.isEmpty()) return menu;
  return QString("%1 › %2").arg(menu, withoutMnemonics(command.submenu));
}

QString CommandRegistry::nameOf(const CommandDescription& command) const {
  return withoutMnemonics(action(command.id)->text());
}

QAction* CommandRegistry::action(const QString& id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : found->second.action;
}

QString CommandRegistry::run(const QString& id) {
  const CommandDescription& command = commands_[entries_.at(id).row];
  const QString objection = objectionTo(command);
  if (objection.isEmpty()) command.run();
  refresh();
  return objection;
}

void CommandRegistry::fill(QMenuBar& bar) const {
  for (const Menu which : {Menu::file, Menu::edit, Menu::view, Menu::fit, Menu::help}) {
    QMenu* menu = bar.addMenu(titleOf(which));
    // They say why a command cannot run.
    menu->setToolTipsVisible(true);
    for (const CommandDescription& command : commands_) {
      if (command.menu != which) continue;
      if (command.beginsSection) menu->addSeparator();
      submenuOf(*menu, command.submenu).addAction(action(command.id));
    }
  }
}

void CommandRegistry::refresh() {
  for (const auto& [id, entry] : entries_)
    refresh(commands_[entry.row], *entry.action);
}

void CommandRegistry::refresh(const CommandDescription& command, QAction& action) {
  const QString objection = objectionTo(command);
  action.setEnabled(objection.isEmpty());
  action.setToolTip(objection.isEmpty() ? command.toolTip : objection);
  action.setText(command.textNow ? command.textNow() : command.text);
  if (command.isOn) action.setChecked(command.isOn());
}

}  // namespace cutis
