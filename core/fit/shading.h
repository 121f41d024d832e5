#pragma once

// A factor on all channels of a pixel, for photographs that are not pure albedo: the slope of the
// skin, a cast shadow, a lamp that falls off.
//
// Its prior is normal around 1. Given the skin, the most probable factor is known in closed form,
// so that the fit looks for the five parameters alone, with the factor following them ("variable
// projection", Golub & Pereyra 1973): core/fit/refined/linearise-inl.h. Thread-safe.

#include "core/base/pixel_rows.h"
#include "core/rig/rig.h"

namespace cutis {

// The standard deviation over a face without cast shadows, which --shading assumes.
inline constexpr double kUsualShadingDeviation = 0.25;

struct ShadingModel {
  NoiseModel noise;
  double deviation = kUsualShadingDeviation;  // positive
};

// s that minimises Σ (y − s f)² / σ² + (s − 1)² / deviation² over the channels y as measured, f as
// modelled: of one pixel, the same rows of both. NaN where a channel is.
float shadingFactor(const ShadingModel& model, PixelRows<const float> measured,
                    PixelRows<const float> modelled);

}  // namespace cutis
