#pragma once  // internal to ui/menus

// The rows of the table of commands that compare what is shown with something else.

#include <vector>

#include "ui/commands/command_description.h"
#include "ui/menus/editor.h"

namespace cutis {

std::vector<CommandDescription> compareCommands(const Editor& editor);

}  // namespace cutis
