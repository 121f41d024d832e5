#include "src/cli/options/common_options.h"

#include "src/cli/options/add_option.h"
#include "src/cli/options/option_values.h"

namespace cutis {
namespace {

constexpr int kMostThreads = 1024;

}  // namespace

void addCommonOptions(CLI::App& command, CommonOptions& options) {
  addOption(command, "--threads", options.threads, "N",
            "Cores to use (default: all); the result is the same for any number");
  command.add_flag("--quiet", options.quiet, "Print errors only: no progress and no notes");
  command.set_version_flag("--version", "cutis-cli " CUTIS_VERSION, "Print the version and exit");
}

Result<int> threadCount(const CommonOptions& options) {
  if (options.threads.empty()) return 0;
  return wholeNumber("--threads", options.threads, 1, kMostThreads);
}

}  // namespace cutis
