#pragma once  // internal to ui/documents

#include <vector>

#include "ui/docks/dock_description.h"

namespace cutis {

class CommandRegistry;
class DocumentPage;

// The docks of a page. A new one is a panel, a controller and a row here: its place in the menu,
// its shortcut and its memory come from the row. All outlive the docks.
std::vector<DockDescription> dockCatalogue(DocumentPage& page, CommandRegistry& commands);

}  // namespace cutis
