#include "src/color/color_space.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "src/color/builtin_space.h"
#include "src/color/ocio_config.h"
#include "src/files/io/suggestion.h"

namespace cutis {
namespace {

// Exactly one of the two.
struct Found {
  std::optional<int> builtIn;
  std::shared_ptr<const OcioConfig> config;
};

Result<Found> find(const std::string& name, const std::string& place) {
  Found found;
  found.builtIn = builtInSpace(name);
  if (found.builtIn) return found;
  CUTIS_TRY(config, OcioConfig::fromEnvironment());
  if (config && config->has(name)) {
    found.config = config;
    return found;
  }
  return inputError(place,
                    "unknown colour space '" + name + "'; " + suggestName(name, colorSpaceNames()));
}

}  // namespace

Result<ColorConverter> toLinearRec709(const std::string& name, const std::string& place) {
  CUTIS_TRY(found, find(name, place));
  if (found.builtIn) return builtInToLinearRec709(*found.builtIn);
  return found.config->toLinearRec709(name, place);
}

Result<ColorConverter> fromLinearRec709(const std::string& name, const std::string& place) {
  CUTIS_TRY(found, find(name, place));
  if (found.builtIn) return builtInFromLinearRec709(*found.builtIn);
  return found.config->fromLinearRec709(name, place);
}

Result<std::string> canonicalColorSpace(const std::string& name, const std::string& place) {
  CUTIS_TRY(found, find(name, place));
  if (found.builtIn) return builtInSpaceName(*found.builtIn);
  return found.config->canonicalName(name);
}

std::vector<std::string> colorSpaceNames() {
  std::vector<std::string> names = builtInSpaceNames();
  const auto config = OcioConfig::fromEnvironment();
  if (!config || !config.value()) return names;
  for (std::string& name : config.value()->names()) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(std::move(name));
    }
  }
  return names;
}

}  // namespace cutis
