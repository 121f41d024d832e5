#include "core/rig/rig.h"

#include <cmath>
#include <cstddef>
#include <set>

#include "core/base/content_hash.h"
#include "core/base/echoed_text.h"
#include "core/base/word_list.h"

namespace cutis {
namespace {

// As a standard deviation; the perfect diffuser reads 1.
constexpr double kMostNoise = 1.0;

std::string lightList(const Rig& rig) {
  std::vector<std::string> names;
  for (const RigLight& light : rig.lights)
    names.push_back(light.name);
  return wordList(names, ", ");
}

bool isPower(const Spectrum& spectrum) {
  return spectrum.isFinite().all() && (spectrum >= 0.0).all();
}

}  // namespace

std::string Rig::channelName(int channel) const {
  return lights[static_cast<std::size_t>(channel / 3)].name + "." +
         camera.channelNames[static_cast<std::size_t>(channel % 3)];
}

int Rig::lightIndex(const std::string& lightName) const {
  for (std::size_t k = 0; k < lights.size(); ++k) {
    if (lights[k].name == lightName) return static_cast<int>(k);
  }
  return -1;
}

Status validate(const Rig& rig, const std::string& place) {
  if (rig.lights.empty()) return inputError(place, "lights is empty; name at least one light");
  if (rig.lights.size() > kMaximumLights) {
    return inputError(place, "lights lists " + std::to_string(rig.lights.size()) +
                                 " lights; list at most " + std::to_string(kMaximumLights));
  }
  std::set<std::string> names;
  for (const RigLight& light : rig.lights) {
    if (!names.insert(light.name).second) {
      return inputError(
          place, "two lights are called " + inQuotes(light.name) + "; give each its own name");
    }
    if (!isPower(light.power) || light.power.sum() <= 0.0) {
      return inputError(place, "light " + inQuotes(light.name) +
                                   " has negative, missing or no power between 300 and 1000 nm; "
                                   "correct its spectrum or mix");
    }
  }
  for (int c = 0; c < 3; ++c) {
    if (!isPower(rig.camera.sensor.sensitivity.row(c).transpose())) {
      return inputError(place, "camera.sensitivity has negative or missing values in column " +
                                   rig.camera.channelNames[static_cast<std::size_t>(c)] +
                                   "; correct the file");
    }
  }
  for (const double deviation : {rig.noise.read, rig.noise.proportional}) {
    if (!(deviation >= 0.0 && deviation <= kMostNoise)) {
      return inputError(
          place, "noise must be finite and not negative, and at most 1, the perfect diffuser");
    }
  }
  return {};
}

Result<Rig> withLights(const Rig& rig, const std::vector<std::string>& names,
                       const std::string& place) {
  if (names.empty()) {
    return usageError(place,
                      "no light is named; rig " + inQuotes(rig.name) + " has " + lightList(rig));
  }
  Rig selected = rig;
  selected.lights.clear();
  for (const std::string& name : names) {
    const int index = rig.lightIndex(name);
    if (index < 0) {
      return inputError(place, "rig " + inQuotes(rig.name) + " has no light " + inQuotes(name) +
                                   "; it has " + lightList(rig));
    }
    if (selected.lightIndex(name) >= 0) {
      return usageError(place, "light " + inQuotes(name) + " is named twice");
    }
    selected.lights.push_back(rig.lights[static_cast<std::size_t>(index)]);
  }
  return selected;
}

SpectrumRows responseRows(const Rig& rig) {
  SpectrumRows rows(rig.channelCount(), kSampleCount);
  for (int k = 0; k < static_cast<int>(rig.lights.size()); ++k) {
    rows.middleRows(3 * k, 3) =
        channelRows(rig.lights[static_cast<std::size_t>(k)].power, rig.camera.sensor);
  }
  return rows;
}

std::string fingerprint(const Rig& rig) {
  ContentHash hash;
  for (int c = 0; c < 3; ++c) {
    const Spectrum curve = rig.camera.sensor.sensitivity.row(c).transpose();
    hash.add(std::span<const double>(curve.data(), kSampleCount));
  }
  for (const RigLight& light : rig.lights) {
    hash.add(std::span<const double>(light.power.data(), kSampleCount));
  }
  return hash.digest();
}

}  // namespace cutis
