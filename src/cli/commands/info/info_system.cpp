#include "src/cli/commands/info/info_system.h"

#include <vector>

#include "core/base/instruction_set.h"
#include "core/base/parallel.h"
#include "src/color/color_space.h"
#include "src/files/io/platform.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/rig_file.h"
#include "src/files/spectral_library.h"

namespace cutis {
namespace {

std::string line(const std::string& name, const std::string& value) {
  return name + ": " + (value.empty() ? "unknown" : value) + "\n";
}

std::string listOf(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

std::string describeSystem() {
  return line("version", CUTIS_VERSION) + line("instruction set", instructionSetName()) +
         line("processor", processorName()) +
         line("threads", std::to_string(parallelThreadCount())) +
         line("cache", cacheFolder().string()) + line("profiles", listOf(profileNames())) +
         line("rigs", listOf(rigNames())) + line("lights", listOf(lightNames())) +
         line("observers", listOf(observerNames())) + line("cameras", listOf(cameraNames())) +
         line("displays", listOf(displayNames())) +
         line("colour spaces", listOf(colorSpaceNames()));
}

}  // namespace cutis
