#include "src/cli/commands/info/info_system.h"

#include <vector>

#include "core/base/instruction_set.h"
#include "core/base/parallel.h"
#include "core/base/word_list.h"
#include "src/color/color_space.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/rig_file.h"
#include "src/files/spectral_library.h"
#include "src/files/system/platform.h"

namespace cutis {
namespace {

std::string systemLine(const std::string& name, const std::string& value) {
  return name + ": " + (value.empty() ? "unknown" : value) + "\n";
}

}  // namespace

std::string describeSystem() {
  return systemLine("version", CUTIS_VERSION) +
         systemLine("instruction set", instructionSetName()) +
         systemLine("processor", processorName()) +
         systemLine("threads", std::to_string(parallelThreadCount())) +
         systemLine("cache", cacheFolder().string()) +
         systemLine("profiles", wordList(profileNames(), ", ")) +
         systemLine("rigs", wordList(rigNames(), ", ")) +
         systemLine("lights", wordList(lightNames(), ", ")) +
         systemLine("observers", wordList(observerNames(), ", ")) +
         systemLine("cameras", wordList(cameraNames(), ", ")) +
         systemLine("displays", wordList(displayNames(), ", ")) +
         systemLine("colour spaces", wordList(colorSpaceNames(), ", "));
}

}  // namespace cutis
