#pragma once

// What the spectrum of a place is made of: how much its two layers absorb, and what each
// chromophore takes from its reflectance.
//
// Of the edited skin; of a square of pixels that of the mean parameters. Constants are those of the
// profile, also where the fit found a pixel's own. Pure, thread-safe; about 0.5 ms.

#include <utility>
#include <vector>

#include "core/skin/model/skin_model.h"
#include "src/app/document/place_spectra.h"

namespace cutis {

struct PlaceParts {
  Spectrum epidermis, dermis;  // absorption, mm⁻¹
  // For each concentration: the reflectance without it minus that with it, the others as they are.
  // They do not add up to anything, since chromophores absorb what others have left.
  std::vector<std::pair<Parameter, Spectrum>> contributions;
};

PlaceParts placeParts(const SkinModel& model, const PlaceSpectra& place);

}  // namespace cutis
