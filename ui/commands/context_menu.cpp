#include "ui/commands/context_menu.h"

#include <QMenu>

#include "ui/commands/command_registry.h"

namespace cutis {

QMenu* commandMenu(QWidget& widget, CommandRegistry& commands, const QStringList& ids) {
  auto* menu = new QMenu(&widget);
  menu->setToolTipsVisible(true);
  QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, &commands, ids] {
    commands.refresh();
    menu->clear();
    for (const QString& id : ids) {
      if (id.isEmpty()) {
        menu->addSeparator();
      } else if (QAction* action = commands.action(id)) {
        menu->addAction(action);
      }
    }
  });
  return menu;
}

void giveContextMenu(QWidget& widget, CommandRegistry& commands, const QStringList& ids) {
  QMenu* menu = commandMenu(widget, commands, ids);
  widget.setContextMenuPolicy(Qt::CustomContextMenu);
  QObject::connect(
      &widget, &QWidget::customContextMenuRequested, menu,
      [&widget, menu](const QPoint& place) { menu->popup(widget.mapToGlobal(place)); });
}

}  // namespace cutis
