#include "ui/commands/context_menu.h"

#include <QMenu>

#include "ui/commands/command_registry.h"

namespace cutis {

void giveContextMenu(QWidget& widget, CommandRegistry& commands, const QStringList& ids) {
  widget.setContextMenuPolicy(Qt::CustomContextMenu);
  QObject::connect(&widget, &QWidget::customContextMenuRequested, &widget,
                   [&widget, &commands, ids](const QPoint& place) {
                     commands.refresh();
                     auto* menu = new QMenu(&widget);
                     menu->setAttribute(Qt::WA_DeleteOnClose);
                     menu->setToolTipsVisible(true);
                     for (const QString& id : ids) {
                       if (id.isEmpty()) {
                         menu->addSeparator();
                       } else if (QAction* action = commands.action(id)) {
                         menu->addAction(action);
                       }
                     }
                     menu->popup(widget.mapToGlobal(place));
                   });
}

}  // namespace cutis
