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

std::string systemLine(const std::string& name, const std::string& value) {
  return name + ": " + (value.empty() ? "unknown" : value) + "\n";
}

std::string namesOf(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

std::string describeSystem() {
  return systemLine("version", CUTIS_VERSION) +
         systemLine("instruction set", instructionSetName()) +
         systemLine("processor", processorName()) +
         systemLine("threads", std::to_string(parallelThreadCount())) +
         systemLine("cache", cacheFolder().string()) +
         systemLine("profiles", namesOf(profileNames())) + systemLine("rigs", namesOf(rigNames())) +
         systemLine("lights", namesOf(lightNames())) +
         systemLine("observers", namesOf(observerNames())) +
         systemLine("cameras", namesOf(cameraNames())) +
         systemLine("displays", namesOf(displayNames())) +
         systemLine("colour spaces", namesOf(colorSpaceNames()));
}

}  // namespace cutis
