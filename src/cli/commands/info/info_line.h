#pragma once  // internal to src/cli/commands/info

#include <string>

#include "core/base/echoed_text.h"

namespace cutis {

// "name: value" on one line; nothing where there is no value.
inline std::string line(const std::string& name, const std::string& value) {
  return value.empty() ? "" : onOneLine(name + ": " + value) + "\n";
}

}  // namespace cutis
