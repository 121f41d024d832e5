#pragma once

// Absorption of both layers of many skins at once, each with an oxygenation of its own
// (core/skin/profile/absorption.h, core/skin/free/free_blood.h), and the chain rule that goes with
// it.
//
// Thread-safe: const after construction. A skin's values are its own, whatever the others are.

#include <span>
#include <vector>

#include "core/skin/free/free_blood.h"
#include "core/skin/profile/absorption.h"

namespace cutis {

class FreeAbsorption {
 public:
  // samples: positions on the wavelength grid. As FreeBlood where oxygenation is not free.
  // Preconditions: validate(profile) passed; there are no further chromophores (requireFive()).
  FreeAbsorption(const Profile& profile, std::span<const int> samples, bool freeOxygenation);

  const AbsorptionLaw& law() const { return law_; }

  // mm⁻¹; [sample][skin].
  struct Values {
    std::vector<double> epidermal, dermal;
    FreeBlood::Values blood;
  };
  // One oxygenation of the dermis a skin, 0 to 1.
  Values at(std::span<const ParameterVector> parameters,
            std::span<const double> dermalOxygenations) const;

 private:
  std::vector<int> samples_;
  AbsorptionLaw law_;
  FreeBlood blood_;
};

}  // namespace cutis
