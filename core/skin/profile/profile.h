#pragma once

// All constants of the skin model. The paper's are the profile `li2024`; others come from
// profile.json. Absorption and scattering in mm⁻¹, wavelengths in nm.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/skin/profile/chromophore_table.h"
#include "core/skin/profile/discrepancy.h"
#include "core/skin/profile/parameter_axis.h"
#include "core/skin/profile/prior.h"
#include "core/skin/profile/spectral_laws.h"
#include "core/spectra/grid.h"

namespace cutis {

// Skin without chromophores: constant + tail; paper, eq. 5.
struct BaselineAbsorption {
  double constant = 0.0;
  ExponentialTail tail;
};

// Reduced scattering: the sum of both; paper, eq. 6.
struct ReducedScattering {
  PowerLaw mie;
  PowerLaw rayleigh;
};

// The blood of one layer.
struct BloodOptics {
  double oxygenation = 0.0;  // γ: share of oxyhaemoglobin
  // Blood lies in vessels, whose middle sees less light than their wall: whole blood of absorption
  // q in tubes of this radius r acts as q (1 − e^(−2qr)) / (2qr) of it, spread evenly (packaging;
  // after Duysens 1956). 0: spread evenly.
  double vesselRadiusMm = 0.0;
};

// How β-carotene in skin differs from its tabulated solution.
struct CaroteneInSkin {
  double scale = 1.0;        // absorption of a unit of the parameter, per g/L of the solution
  double shiftNm = 0.0;      // of the spectrum, towards longer wavelengths
  double smoothingNm = 0.0;  // standard deviation of a Gaussian
};

// Which theory turns absorption and scattering of the two layers into reflectance.
enum class LayerOpticsKind {
  diffusion,       // multipole over dipole in closed form (Donner & Jensen 2005, 2006)
  addingDoubling,  // radiative transfer (core/transport/adding_doubling.h)
};

// The defaults of what the paper does not have leave the paper's model.
struct Profile {
  std::string name;
  std::string description;

  ParameterAxes axes = paperAxes();
  Prior prior;
  // What the model leaves over of measured skin; most profiles do not know.
  Discrepancies discrepancies;
  // Beyond the five, as rows of their own; no file holds them.
  std::vector<Chromophore> further;

  // Absorption of the pure chromophores.
  PowerLaw eumelanin;    // paper, eq. 3
  PowerLaw pheomelanin;  // paper, eq. 4
  BaselineAbsorption baseline;
  Spectrum oxyhaemoglobin = Spectrum::Zero();    // whole blood, fully oxygenated
  Spectrum deoxyhaemoglobin = Spectrum::Zero();  // whole blood, fully deoxygenated
  double bloodSmoothingNm = 0.0;  // standard deviation of a Gaussian over blood, packaging included
  Spectrum water = Spectrum::Zero();
  Spectrum carotene = Spectrum::Zero();  // per unit of the parameter, 1 g/L
  CaroteneInSkin caroteneInSkin;
  GaussianBand fat;

  // Epidermis.
  double epidermalThicknessMm = 0.0;
  double epidermalWater = 0.0;  // C_we, volume fraction
  BloodOptics epidermalBlood;
  ExponentialTail epidermalUltraviolet;  // on top of its baseline, and displaced with it
  ReducedScattering epidermalScatteringLaw;

  // Dermis.
  double dermalWater = 0.0;  // C_wd, volume fraction
  BloodOptics dermalBlood;
  double dermalBaselineFactor = 1.0;  // its baseline over that of the profile
  double dermalFat = 0.0;             // volume fraction; displaces nothing
  // The dermis scatters by a law of its own, or by a share of the epidermis, which is not a number
  // where there is a law.
  std::optional<ReducedScattering> dermalScatteringLaw;
  double dermalScatteringRatio = std::numeric_limits<double>::quiet_NaN();

  double refractiveIndex = 1.0;  // of both layers
  LayerOpticsKind layerOptics = LayerOpticsKind::diffusion;
};

// The numbers that describe skin of a profile are the five and the amounts of its further
// chromophores, in this order; of these, how many there are, the row and the range of one.
// Precondition: 0 ≤ parameter < parameterCount(profile).
int parameterCount(const Profile& profile);
const Chromophore& chromophoreOf(const Profile& profile, int parameter);
const ParameterAxis& axisOf(const Profile& profile, int parameter);

// Every combination of the ends of their ranges. Absorption is linear in each parameter while the
// others stand still, so that its extremes are among these.
std::vector<std::vector<double>> boxCorners(const Profile& profile);

// Refuses a profile with further chromophores where only the five are known; `what` is named in the
// sentence: "a fit of photographs".
Status requireFive(const Profile& profile, const std::string& what);

// Checks what the equations need: positive ranges and scattering, fractions within [0, 1], finite
// numbers, a proper prior, an epidermis thick enough for its layer optics; and that a table of its
// samples fits into memory. NaN fails. `place` names the source in the error.
Status validate(const Profile& profile, const std::string& place);

// Identifies everything that changes a reflectance or a table: equal fingerprints, equal results.
// The prior, the discrepancies, the name and the description are not part of it.
std::string fingerprint(const Profile& profile);

}  // namespace cutis
