#pragma once

// How an instrument or a photograph sees the skin: from the model's reflectance, per flux that
// enters, to what is measured, per flux that arrives.
//
//   measured = s + e R(σ_d + k² / (3 (σ_s' + σ_d)))
//
// s: the surface's reflection, as far as it reaches the detector; e: the share of the light that
// enters; k: light that a small aperture loses sideways. Such light is missing as if it had been
// absorbed in the dermis: where a diffusing field varies across the surface like a mode of wave
// number k, −D ∇² adds k² D to the absorption, with D = 1 / (3 (σ_s' + σ_a)) the diffusion
// coefficient.
//
// Shares are 0 to 1; k in mm⁻¹, finite and ≥ 0; absorption and reduced scattering in mm⁻¹. NaN in,
// NaN out. Thread-safe: pure functions.

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace cutis {

// What becomes of the reflection at the skin's surface.
enum class SpecularPart {
  included,        // an integrating sphere without a trap
  excluded,        // a trap, or lights out of the mirror direction
  crossPolarised,  // crossed polarisers, also over the white reference: as excluded. They hold back
                   // half of the diffuse light of skin and white alike; the little that skin sends
                   // back after one or two scatterings, still polarised, is not accounted for
};

struct MeasurementGeometry {
  double specularShare = 0.0;  // s
  double enteringShare = 1.0;  // e; 1: the model's own reflectance, as the paper compares it
  double edgeLossPerMm = 0.0;  // k; 0: all light that leaves the skin is collected
};

// Surface reflection of skin at normal incidence where a measurement includes it: Fresnel's for an
// index of 1.5, that of the horny layer. The calibration of the profile skin2026 found 0.037 and
// 0.045 with two instruments.
inline constexpr double kSkinSpecularShare = 0.04;

// Light along the normal: e = 1 − ((η − 1) / (η + 1))² for skin of refractive index η (1 to 2).
// `share` is s and counts only where the specular part is included. No edge loss.
MeasurementGeometry measurementGeometry(SpecularPart part, double refractiveIndex,
                                        double share = kSkinSpecularShare);

// k of a round aperture that lights and sees the same spot: the first zero of the Bessel function
// J₀, 2.405, over its radius (> 0).
double edgeLossOfAperture(double radiusMm);

// Refuses what lies outside the ranges above; `place` names the source in the error.
Status validate(const MeasurementGeometry& geometry, const std::string& place);

// s + e R, and its inverse (precondition: e > 0).
double measuredReflectance(const MeasurementGeometry& geometry, double reflectance);
double modelReflectance(const MeasurementGeometry& geometry, double measured);
std::vector<double> modelReflectances(const MeasurementGeometry& geometry,
                                      std::span<const double> measured);

// A dermal absorption as it acts under the geometry's edge loss, and its derivative with respect to
// the absorption: between −∞ and 1, since the loss falls as absorption rises. Precondition:
// absorption + scattering > 0.
struct EffectiveAbsorption {
  double absorption = 0.0;  // mm⁻¹
  double slope = 1.0;
};
EffectiveAbsorption withEdgeLoss(const MeasurementGeometry& geometry, double dermalAbsorption,
                                 double dermalScattering);

}  // namespace cutis
