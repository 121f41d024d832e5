#pragma once

// Absorption of the two layers as linear forms (paper, eq. 1 and 2). mm⁻¹.
//
//   epidermis: σ_a = base + C_m [β_m · eumelanin + (1 − β_m) · pheomelanin]
//                         + C_he · blood + C_bc · carotene
//   dermis:    σ_a = base + C_hd · blood
//
// where tissue includes the epidermis's ultraviolet tail and the dermis's fat, blood is that of the
// layer (oxygenation, packaging, smoothing) and carotene that in skin. Each chromophore displaces
// baseline tissue; the coefficients here are net of that and may be
// negative where a chromophore absorbs less than the tissue it displaces.

#include "core/skin/profile/parameter_axis.h"
#include "core/skin/profile/profile.h"
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

// Absorption of undiluted blood as it lies in a layer.
Spectrum bloodIn(const Profile& profile, const BloodOptics& layer);

// (1 − e^(−2qr)) / (2qr) for absorption q (≥ 0) in vessels of radius r (≥ 0): 1 where either is 0.
double packagingFactor(double absorptionPerMm, double radiusMm);

// Reduced scattering; paper, eq. 6 for the epidermis.
Spectrum epidermalScattering(const Profile& profile);
Spectrum dermalScattering(const Profile& profile);

// The longest transport mean free path in an epidermis without chromophores, 300 to 1000 nm: the
// thinnest slab that diffusion describes.
double longestPathMm(const Profile& profile);

}  // namespace cutis
