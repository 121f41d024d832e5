#pragma once

// Profiles, rigs and spectra for tests, loaded once.

#include <string>

#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "core/spectra/colorimetry.h"

namespace cutis::test {

const SkinModel& li2024();
const Rig& monitorRig();
const Rig& albedoRig();

// A light of the built-in library.
Spectrum light(const std::string& name);
const Sensor& cie1931();
// D65 under the standard observer; Y = 1.
Eigen::Vector3d daylightWhite();

}  // namespace cutis::test
