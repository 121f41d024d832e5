#pragma once

// Plane-integrated diffusion optics of a slab and of a half-space, in closed form (Jensen et al.
// 2001; Donner & Jensen 2005). Absorption and scattering in mm⁻¹, lengths in mm.
//
// With σ_t' = σ_a + σ_s', α' = σ_s'/σ_t', ℓ = 1/σ_t', σ_tr = √(3 σ_a σ_t'), s = σ_tr ℓ and
// extrapolation distances z = ⅔ A ℓ, the multipole series is geometric. In the decaying
// exponentials
//
//   p = e^(−s), q_i = e^(−2 σ_tr z_i), q_o = e^(−2 σ_tr z_o), t = e^(−σ_tr d)
//
// its sum is, for light from side i (o is the far side),
//
//   R = ½ α' (1 + q_i) (p² − t² q_o) / (p (1 − t² q_i q_o))
//   T = ½ α' t (1 + q_o) (1 − p² q_i) / (p (1 − t² q_i q_o))
//
// which never overflows, however thick or dark the slab. Templates on the scalar: double, or Dual
// for derivatives. Valid for σ_s' > 0, σ_a ≥ 0 and d ≥ ℓ; no absorption is the limit σ_a → 0.

#include <algorithm>
#include <cmath>

#include "core/maths/dual.h"

namespace cutis {

// (1 + F) / (1 − F) with F the diffuse Fresnel reflectance at the boundary seen from inside
// (fit by Egan & Hilgeman for η > 1; Jensen et al. 2001). 1 for η = 1.
inline double boundaryFactor(double refractiveIndex) {
  if (refractiveIndex == 1.0) return 1.0;
  const double f = -1.4399 / (refractiveIndex * refractiveIndex) + 0.7099 / refractiveIndex +
                   0.6681 + 0.0636 * refractiveIndex;
  return (1.0 + f) / (1.0 - f);
}

template <typename Scalar>
struct SlabOptics {
  Scalar reflectance, transmittance;                    // lit from side i
  Scalar reflectanceFromBelow, transmittanceFromBelow;  // lit from side o
};

namespace diffusion {

// The closed form is 0/0 at s = 0. It is even in s, so stopping here errs by about s².
inline constexpr double kSmallestArgument = 1e-7;

template <typename Scalar>
struct Medium {
  Scalar albedo;          // α'
  Scalar argument;        // s = σ_tr ℓ
  Scalar effectivePerMm;  // σ_tr
};

template <typename Scalar>
Medium<Scalar> medium(const Scalar& absorption, double scattering) {
  using std::max;
  using std::sqrt;
  const Scalar extinction = absorption + scattering;
  const Scalar argument =
      sqrt(max(3.0 * absorption / extinction, Scalar(kSmallestArgument * kSmallestArgument)));
  return {scattering / extinction, argument, argument * extinction};
}

}  // namespace diffusion

// Slab of thickness d, a double or a Scalar, with boundary factors A_i at the lit side and A_o at
// the far side.
template <typename Scalar, typename Length>
SlabOptics<Scalar> slabOptics(const Scalar& absorption, double scattering, const Length& thickness,
                              double factorNear, double factorFar) {
  using std::exp;
  using std::expm1;
  const auto [albedo, s, effective] = diffusion::medium(absorption, scattering);
  const Scalar depth = effective * thickness;
  const Scalar nearGap = 4.0 / 3.0 * factorNear * s;
  const Scalar farGap = 4.0 / 3.0 * factorFar * s;
  const Scalar qNear = exp(-nearGap);
  const Scalar qFar = exp(-farGap);
  const Scalar t = exp(-depth);
  const Scalar p = exp(-s);
  // Differences of exponentials as expm1: exact to the last digits for thin or clear slabs too.
  const Scalar denominator = -expm1(-(2.0 * depth + nearGap + farGap));
  const Scalar front = 0.5 * albedo / denominator;
  SlabOptics<Scalar> slab;
  slab.reflectance = front * (1.0 + qNear) * p * -expm1(-(2.0 * depth + farGap - 2.0 * s));
  slab.reflectanceFromBelow = front * (1.0 + qFar) * p * -expm1(-(2.0 * depth + nearGap - 2.0 * s));
  slab.transmittance = front * t * (1.0 + qFar) * -expm1(-(2.0 * s + nearGap)) / p;
  slab.transmittanceFromBelow = front * t * (1.0 + qNear) * -expm1(-(2.0 * s + farGap)) / p;
  return slab;
}

// Semi-infinite medium with boundary factor A.
template <typename Scalar>
Scalar halfSpaceReflectance(const Scalar& absorption, double scattering, double factor) {
  using std::exp;
  const auto [albedo, s, effective] = diffusion::medium(absorption, scattering);
  return 0.5 * albedo * exp(-s) * (1.0 + exp(-(4.0 / 3.0 * factor) * s));
}

// Kubelka–Munk adding of a slab over something of diffuse reflectance r.
template <typename Scalar, typename Below>
auto addedReflectance(const SlabOptics<Scalar>& slab, const Below& r) {
  return slab.reflectance + slab.transmittance * slab.transmittanceFromBelow * r /
                                (1.0 - slab.reflectanceFromBelow * r);
}

}  // namespace cutis
