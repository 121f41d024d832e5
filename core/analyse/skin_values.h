#pragma once

// How the values of maps are spread over what can be skin, for ranges in which a map can be read:
// hair, eyes and background would otherwise take most of the scale.
//
// Looked at is a regular sample of the pixels with an estimate, at most about 65,000 and all of a
// small picture. Deterministic; some milliseconds.

#include <array>
#include <optional>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/pixel_solver.h"
#include "core/rig/measurements.h"
#include "core/skin/chromophore_maps.h"
#include "core/skin/profile/parameter_axis.h"

namespace cutis {

// Of each parameter in ascending order, in its unit.
struct SkinValues {
  std::array<std::vector<float>, kParameterCount> sorted;
};

// Of pixels that can be skin of the profile (core/analyse/skin_likeness.h says which) and whose
// concentrations are below the ends of their ranges: where one is at its end, no skin explains the
// pixel. Where that leaves fewer than one pixel in a hundred, all pixels count. `noise`: as in
// measureGamut().
Result<SkinValues> skinValuesOf(const Measurements& measurements, const ChromophoreMaps& maps,
                                const PixelSolver& solver, const std::optional<NoiseModel>& noise,
                                const ParameterAxes& axes, const JobContext& context);

// Of maps whose measurements are not at hand: nothing is known but their concentrations.
Result<SkinValues> skinValuesOf(const ChromophoreMaps& maps, const ParameterAxes& axes,
                                const JobContext& context);

struct ValueRange {
  double minimum = 0.0;
  double maximum = 1.0;
};

// From the 1st to the 99th of a hundred values; none without values, or where these are one.
std::optional<ValueRange> typicalRange(const std::vector<float>& sorted);

}  // namespace cutis
