#pragma once

#include <vector>

#include "ui/commands/command_description.h"
#include "ui/menus/editor.h"

namespace cutis {

// The commands of the editor in the order of the menus, those of the views and docks among them.
// Everything of the editor outlives the commands; its docks are there already.
std::vector<CommandDescription> commandCatalogue(const Editor& editor);

}  // namespace cutis
