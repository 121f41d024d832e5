#pragma once

// What a refined fit took for granted of a picture, apart from the profile: all that it takes to
// say afterwards how far a pixel's spectrum may lie from the estimate. Maps carry it.
//
// Plain data, thread-safe when const.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/fit/fit_options.h"
#include "core/rig/rig.h"
#include "core/skin/profile/profile.h"

namespace cutis {

struct FitRecord {
  std::vector<std::string> lights;
  std::vector<std::string> channels;  // "white.R", …
  SpectrumRows responses;             // of the channels, as responseRows()
  NoiseModel noise;                   // as it was assumed
  Prior prior;                        // as it was assumed
  std::array<std::optional<double>, kParameterCount> fixed = {};
  FreeConstants free;
  std::optional<double> shading;  // standard deviation of the factor, where it was estimated
  SurfaceLight surface = SurfaceLight::included;
  bool discrepancy = false;  // whether that of the profile for this surface was estimated
};

// What a fit with these options is described by. Precondition: the method is refined.
FitRecord fitRecord(const Profile& profile, const Rig& rig, const FitOptions& options);

// Channels and responses of one number, responses that are finite and not negative, proper noise
// and prior, held parameters within the profile's ranges, and a discrepancy that the profile knows.
// `place` stands in front of an error.
Status validate(const FitRecord& record, const Profile& profile, const std::string& place);

}  // namespace cutis
