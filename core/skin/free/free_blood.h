#pragma once  // internal to core/skin/free

// Absorption of blood in both layers as a function of its oxygenation γ, packaging and smoothing
// included, which are not linear in γ.
//
// A polynomial of γ through kBloodPoints spectra of each layer: within 2e-5 of the largest
// absorption of core/skin/profile/absorption.h for γ from 0 to 1, exact where blood lies in no
// vessels. Thread-safe: const after construction.

#include <span>
#include <vector>

#include "core/maths/chebyshev_weights.h"
#include "core/skin/profile/profile.h"

namespace cutis {

inline constexpr int kBloodPoints = 8;

class FreeBlood {
 public:
  // samples: positions on the wavelength grid. Where oxygenation is not free, that of the profile
  // holds, whatever is asked for. Precondition: validate(profile) passed.
  FreeBlood(const Profile& profile, std::span<const int> samples, bool free);

  // Per volume fraction, net of the tissue it displaces, and the derivatives by the dermal γ; mm⁻¹;
  // [sample][skin].
  struct Values {
    std::vector<double> dermal, epidermal, dermalSlope, epidermalSlope;
  };
  // dermalOxygenations: one a skin, 0 to 1; that of the epidermis follows
  // (epidermalOxygenation()), and where it is held back at an end of its range its slope is 0.
  Values at(std::span<const double> dermalOxygenations) const;

 private:
  Profile profile_;
  bool free_;
  ChebyshevWeights ofDermis_, ofEpidermis_;
  std::vector<double> dermal_, epidermal_;  // [sample][point]
};

}  // namespace cutis
