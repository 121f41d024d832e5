#pragma once

// Menus by the right mouse button, made of the commands of the table. Interface thread only.

#include <QStringList>

class QMenu;
class QWidget;

namespace cutis {

class CommandRegistry;

// A menu of the commands, made anew whenever it is shown, so that the table need not be full yet.
// An empty id is a line between commands; one that is not in the table is left out. The widget owns
// the menu; the registry outlives it, here and below.
QMenu* commandMenu(QWidget& widget, CommandRegistry& commands, const QStringList& ids);

// A right click, or the menu key, on the widget offers the commands.
void giveContextMenu(QWidget& widget, CommandRegistry& commands, const QStringList& ids);

}  // namespace cutis
