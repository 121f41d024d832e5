#pragma once

// What a caller asks of a fit, whatever the method. Fields that only one method knows say so.

#include <array>
#include <memory>
#include <optional>

#include "core/base/plane.h"
#include "core/rig/rig.h"
#include "core/skin/profile/discrepancy.h"
#include "core/skin/profile/free_constants.h"
#include "core/skin/profile/prior.h"

namespace cutis {

struct ChromophoreNetwork;

enum class FitMethod { refined, threeStage, fullSearch, network };

struct FitOptions {
  FitMethod method = FitMethod::refined;
  // The profile's prior and the rig's noise unless given.
  std::optional<Prior> prior;
  std::optional<NoiseModel> noise;
  // Parameters held at a value instead of being estimated (refined only).
  std::array<std::optional<double>, kParameterCount> fixed = {};
  // Standard deviation of a further factor per pixel on all channels, of which 1 is expected; none:
  // the photographs show pure albedo (refined only, core/fit/shading.h).
  std::optional<double> shading;
  // Constants of the profile that are found for each pixel, too (refined only, without shading;
  // core/fit/free/free_solver.h).
  FreeConstants free;
  // Whether the profile's discrepancy (core/skin/profile/discrepancy.h) is estimated, too: refined
  // only, and not beside free constants. Unless given: where the profile knows one and noise is
  // assumed. The exact setting takes the channels for the model's own.
  std::optional<bool> discrepancy;
  // Which of the profile's discrepancies holds for the channels.
  SurfaceLight surface = SurfaceLight::included;
  bool deviations = false;  // posterior standard deviations per value (refined only)
  bool residuals = false;   // measured minus modelled per channel
  PixelFormat mapFormat = PixelFormat::float32;
  // What encodes (network only); none: the one that is built in for rig and profile.
  std::shared_ptr<const ChromophoreNetwork> network;
};

}  // namespace cutis
