#pragma once

// What is known of pinned places: spectra, indices, and how far their colours are apart.

#include <optional>
#include <vector>

#include "core/analyse/skin_indices.h"
#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/app/document/place_spectra.h"
#include "src/app/project/pin.h"

namespace cutis {

struct PinReading {
  Pin pin;
  // None where no pixel of the square has an estimate; the rest is then empty, too.
  std::optional<PlaceSpectra> place;
  // Of the mean spectra.
  SkinIndices original;
  SkinIndices edited;
  // ΔE2000 under D65 for the observer CIE 1931 between the edited skin here and at the reference;
  // none without a reference.
  std::optional<double> difference;
};

// In the order of the pins. Any thread; about 0.3 ms a pixel. Errors: none that is to be expected.
// Cancelled if asked to stop.
Result<std::vector<PinReading>> pinReadings(const SceneSpectra& spectra, const PinSet& set,
                                            const JobContext& context);

}  // namespace cutis
