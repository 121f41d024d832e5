#pragma once  // internal to ui/window

#include <vector>

#include "ui/docks/dock_description.h"
#include "ui/window/editor.h"

namespace cutis {

// The docks of the editor. A new one is a panel, a controller and a row here: its place in the
// menu, its shortcut and its memory come from the row. Everything of the editor outlives the docks.
std::vector<DockDescription> dockCatalogue(const Editor& editor);

}  // namespace cutis
