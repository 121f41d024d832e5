#pragma once

// Menus by the right mouse button, made of the commands of the table. Interface thread only.

#include <QStringList>

class QWidget;

namespace cutis {

class CommandRegistry;

// A right click, or the menu key, on the widget offers the commands; an empty id is a line between
// them, and one that is not in the table is left out. The registry outlives the widget.
void giveContextMenu(QWidget& widget, CommandRegistry& commands, const QStringList& ids);

}  // namespace cutis
