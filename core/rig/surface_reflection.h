#pragma once

// Photographs that hold the reflection of the skin's surface, because no crossed polarisers kept it
// out: taken off, so that what remains is light that has been in the skin.
//
//   measured = s + e · channel,   channel = Σ R S L / Σ S L
//   (core/skin/model/measurement_geometry.h)
//
// s is one number for all pixels, which holds for the even sheen of skin under large lights. It
// does not hold for highlights: they stay, as paler skin.

#include <memory>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/measurements.h"
#include "core/skin/model/measurement_geometry.h"

namespace cutis {

// The noise of channels from which the reflection was taken: it is gone, and its noise is not.
NoiseModel noiseBelowSurface(const NoiseModel& noise, const MeasurementGeometry& geometry);

// Replaces the channels, and the noise of the rig. What is darker than the reflection alone becomes
// 0, and a notice tells if that is more than one pixel in a hundred of those there are. NaN stays.
// Of the geometry the two shares count; with s = 0 nothing is changed. Precondition:
// validate(geometry) passed, e > 0, and the measurements are at exposure 1. Cancelled if asked to
// stop: the measurements are as they were.
Status removeSurfaceReflection(const MeasurementGeometry& geometry,
                               const std::shared_ptr<TileStore>& store, const JobContext& context,
                               Measurements& measurements);

}  // namespace cutis
