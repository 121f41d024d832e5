#pragma once  // internal to ui/menus

#include <vector>

#include "ui/commands/command_description.h"
#include "ui/menus/editor.h"

namespace cutis {

// The commands of spectra, a submenu of Edit, as rows of the table of commands. Everything of the
// editor outlives them.
std::vector<CommandDescription> spectrumCommands(const Editor& editor);

}  // namespace cutis
