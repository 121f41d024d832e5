#include "src/color/color_space.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>

#include "core/base/echoed_text.h"
#include "src/color/builtin_space.h"
#include "src/color/ocio_config.h"
#include "src/files/io/suggestion.h"

namespace cutis {
namespace {

// Behind a name of the configuration that means something else here.
constexpr std::string_view kOfConfig = " ($OCIO)";
// Where tables of a configuration and our formulas agree.
constexpr double kSameAsOurs = 1e-4;

Result<ColorSpace> spaceOfConfig(const OcioConfig& config, const std::string& name,
                                 const std::string& place) {
  CUTIS_TRY(to, config.toLinearRec709(name, place));
  CUTIS_TRY(from, config.fromLinearRec709(name, place));
  ColorSpace space;
  space.name = config.canonicalName(name);
  space.toLinearRec709 = to;
  space.fromLinearRec709 = from;
  space.isNamed = true;
  const auto ours = builtInSpace(space.name);
  if (!ours) return space;
  if (differenceOf(space, builtInSpaceAt(*ours)) <= kSameAsOurs) return builtInSpaceAt(*ours);
  space.name += kOfConfig;
  return space;
}

}  // namespace

Result<ColorSpace> namedColorSpace(const std::string& name, const std::string& place) {
  const bool marked = name.ends_with(kOfConfig);
  const std::string plain = marked ? name.substr(0, name.size() - kOfConfig.size()) : name;
  const auto ours = builtInSpace(plain);
  const auto config = OcioConfig::fromEnvironment();
  if (config && config.value() && config.value()->has(plain)) {
    return spaceOfConfig(*config.value(), plain, place);
  }
  if (ours && !marked) return builtInSpaceAt(*ours);
  if (config.failed()) return config.failure();
  return inputError(place, "unknown colour space " + inQuotes(name) + "; " +
                               suggestName(name, colorSpaceNames()));
}

Result<ColorConverter> toLinearRec709(const std::string& name, const std::string& place) {
  CUTIS_TRY(space, namedColorSpace(name, place));
  return space.toLinearRec709;
}

Result<ColorConverter> fromLinearRec709(const std::string& name, const std::string& place) {
  CUTIS_TRY(space, namedColorSpace(name, place));
  return space.fromLinearRec709;
}

Result<std::string> canonicalColorSpace(const std::string& name, const std::string& place) {
  CUTIS_TRY(space, namedColorSpace(name, place));
  return space.name;
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
