#include "src/cli/options/free_options.h"

#include "core/base/echoed_text.h"
#include "src/cli/options/option_values.h"

namespace cutis {

Result<FreeConstants> freeConstants(const std::string& option, const std::string& text) {
  FreeConstants free;
  for (const std::string& name : commaSeparated(text)) {
    bool* const one = name == "oxygenation" ? &free.oxygenation
                      : name == "thickness" ? &free.thickness
                                            : nullptr;
    if (one == nullptr) {
      return usageError(option, inQuotes(name) +
                                    " cannot be found by a fit; write oxygenation, "
                                    "thickness or oxygenation,thickness");
    }
    if (*one) return usageError(option, inQuotes(name) + " is named twice; name it once");
    *one = true;
  }
  return free;
}

}  // namespace cutis
