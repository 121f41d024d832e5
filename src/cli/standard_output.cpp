#include "src/cli/standard_output.h"

#include <cstdio>

namespace cutis {

Status printText(std::string_view text, const char* objection) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) {
    return {};
  }
  return resourceError("standard output", objection);
}

}  // namespace cutis
