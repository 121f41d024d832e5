#include "src/app/export/overwrite_protection.h"

#include "src/files/io/named_files.h"

namespace cutis {

Status checkNotInput(const std::string& output, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    if (input.empty()) continue;
    for (const std::string& file : inputFiles(input)) {
      if (!isSameFile(output, file)) continue;
      return usageError(output,
                        "this file is read, and sources are never written to; write to "
                        "another file");
    }
  }
  return {};
}

}  // namespace cutis
