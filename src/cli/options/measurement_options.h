#pragma once

// How spectra or photographs see the skin, shared by the commands that read or write them.

#include <string>

#include <CLI/App.hpp>

#include "core/base/result.h"
#include "core/skin/model/measurement_geometry.h"
#include "core/skin/profile/profile.h"

namespace cutis {

// As they were given; empty: not given.
struct MeasurementOptions {
  std::string specular;
  std::string share;
  std::string apertureRadius;
};

// --specular and --specular-share; what: "spectra", "photographs".
void addSpecularOptions(CLI::App& command, const std::string& what, MeasurementOptions& options);
// All that spectra need.
void addMeasurementOptions(CLI::App& command, MeasurementOptions& options);

// What the options say, whatever the skin.
struct MeasurementSetting {
  SpecularPart specular = SpecularPart::excluded;
  double share = kSkinSpecularShare;
  double edgeLossPerMm = 0.0;
};
Result<MeasurementSetting> parseMeasurement(const MeasurementOptions& options);

// Without the specular part, spectra are compared with the model's own reflectance, as the paper
// does; with it, light that is reflected at the surface is missing below.
MeasurementGeometry geometryOf(const MeasurementSetting& setting, const Profile& profile);

// "surface reflection included (0.04), edge loss 0.437 per mm"
std::string described(const MeasurementSetting& setting);

}  // namespace cutis
