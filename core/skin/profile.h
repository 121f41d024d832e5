#pragma once

// All constants of the skin model. The paper's are the profile `li2024`; others come from
// profile.json. Absorption and scattering in mm⁻¹, wavelengths in nm.

#include <string>

#include "core/base/result.h"
#include "core/skin/parameter_axis.h"
#include "core/skin/prior.h"
#include "core/spectra/grid.h"

namespace cutis {

// coefficient · λ^exponent
struct PowerLaw {
  double coefficient = 0.0;
  double exponent = 0.0;
};

// Skin without chromophores: constant + amplitude · exp(−(λ − origin) / decay); paper, eq. 5.
struct BaselineAbsorption {
  double constant = 0.0;
  double amplitude = 0.0;
  double originNm = 0.0;
  double decayNm = 1.0;
};

// Which theory turns absorption and scattering of the two layers into reflectance.
enum class LayerOpticsKind {
  diffusion,  // multipole over dipole in closed form (Donner & Jensen 2005, 2006)
};

struct Profile {
  std::string name;
  std::string description;

  ParameterAxes axes;
  Prior prior;

  // Absorption of the pure chromophores.
  PowerLaw eumelanin;    // paper, eq. 3
  PowerLaw pheomelanin;  // paper, eq. 4
  BaselineAbsorption baseline;
  Spectrum oxyhaemoglobin = Spectrum::Zero();    // whole blood, fully oxygenated
  Spectrum deoxyhaemoglobin = Spectrum::Zero();  // whole blood, fully deoxygenated
  Spectrum water = Spectrum::Zero();
  Spectrum carotene = Spectrum::Zero();  // per unit of the parameter, 1 g/L
  double oxygenation = 0.0;              // γ: share of oxyhaemoglobin

  double epidermalWater = 0.0;  // C_we, volume fraction
  double dermalWater = 0.0;     // C_wd, volume fraction

  // Reduced scattering of the epidermis: the sum of both; paper, eq. 6.
  PowerLaw mieScattering;
  PowerLaw rayleighScattering;
  double dermalScatteringRatio = 0.0;  // dermis over epidermis

  double epidermalThicknessMm = 0.0;
  double refractiveIndex = 1.0;  // of both layers
  LayerOpticsKind layerOptics = LayerOpticsKind::diffusion;
};

// Checks what the equations need: positive ranges and scattering, fractions within [0, 1], finite
// numbers, an epidermis thick enough for its layer optics; and that a table of its samples fits into
// memory. `place` names the source in the error.
Status validate(const Profile& profile, const std::string& place);

// Identifies everything that changes a reflectance or a table: equal fingerprints, equal results.
// The prior, the name and the description are not part of it.
std::string fingerprint(const Profile& profile);

}  // namespace cutis
