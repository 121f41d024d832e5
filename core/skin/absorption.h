#pragma once

// Absorption of the two layers as linear forms (paper, eq. 1 and 2). mm⁻¹.
//
//   epidermis: σ_a = base + C_m [β_m · eumelanin + (1 − β_m) · pheomelanin]
//                         + C_he · blood + C_bc · carotene
//   dermis:    σ_a = base + C_hd · blood
//
// Each chromophore displaces baseline tissue; the coefficients here are net of that and may be
// negative where a chromophore absorbs less than the tissue it displaces.

#include "core/skin/parameter_axis.h"
#include "core/skin/profile.h"
#include "core/spectra/grid.h"

namespace cutis {

struct EpidermalAbsorption {
  Spectrum base, eumelanin, pheomelanin, blood, carotene;
};

struct DermalAbsorption {
  Spectrum base, blood;
};

EpidermalAbsorption epidermalAbsorption(const Profile& profile);
DermalAbsorption dermalAbsorption(const Profile& profile);

double epidermalAbsorptionAt(const EpidermalAbsorption& epidermis, int sample,
                             const ParameterVector& parameters);
double dermalAbsorptionAt(const DermalAbsorption& dermis, int sample,
                          const ParameterVector& parameters);

// Reduced scattering of the epidermis (paper, eq. 6); the dermis has a fixed share of it.
Spectrum epidermalScattering(const Profile& profile);

}  // namespace cutis
