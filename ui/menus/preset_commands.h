#pragma once  // internal to ui/menus

// The rows of the table of commands that take whole sets of edits: presets and the clipboard.

#include <vector>

#include "ui/commands/command_description.h"
#include "ui/menus/editor.h"

namespace cutis {

std::vector<CommandDescription> presetCommands(const Editor& editor);

}  // namespace cutis
