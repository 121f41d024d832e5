#pragma once  // internal to src/cli/commands/info

// The text of `cutis-cli info --system`.

#include <string>

namespace cutis {

// Version, machine and everything built in, in lines of "name: value".
std::string describeSystem();

}  // namespace cutis
