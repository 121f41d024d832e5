#pragma once  // internal to ui/menus

// The rows of the table of commands that choose what is shown: views, the range of their false
// colours, and what is hatched over them.

#include <vector>

#include "ui/commands/command_description.h"
#include "ui/menus/editor.h"

namespace cutis {

std::vector<CommandDescription> viewCommands(const Editor& editor);

}  // namespace cutis
