#pragma once

// What physics leaves over: measured skin over the model's, as a random function of the wavelength
// (Kennedy & O'Hagan 2001).
//
//   R(λ) = R_model(λ; θ) · (1 + mean(λ) + Σ_j z_j component_j(λ) + rest(λ))
//
// z are coefficients of a pixel, and rest is what no coefficient tells. Beside
// parameters whose coordinates x (logarithms where the prior has them) are normal by the prior
// given here, z is normal with mean slope · (x − x̄) and with the covariance given here; x̄ are the
// coordinates of the prior's means. It was learned from measured spectra together with that prior.
//
// It is linear in the coefficients, so that channels, colours and bands are, too. Relative
// reflectance, no unit. Plain data, thread-safe when const.

#include <optional>
#include <string>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/skin/profile/discrepancy_size.h"
#include "core/skin/profile/prior.h"
#include "core/spectra/grid.h"

namespace cutis {

struct Discrepancy {
  Spectrum mean = Spectrum::Zero();
  Eigen::MatrixXd components;  // [sample][coefficient]
  Eigen::MatrixXd slope;       // [coefficient][parameter], per unit of the coordinate
  Eigen::MatrixXd covariance;  // [coefficient][coefficient]
  // rest(λ) = Σ_i n_i rest_i(λ) + n(λ) independentDeviation(λ), all n normal of deviation 1.
  Eigen::MatrixXd rest;  // [sample][i]
  // What varies from wavelength to wavelength by itself; channels average it away.
  Spectrum independentDeviation = Spectrum::Zero();
  Prior prior;

  int count() const { return static_cast<int>(components.cols()); }
  // 1 + mean + Σ_j z_j component_j. Precondition: as many coefficients as there are components.
  Spectrum factor(const Eigen::VectorXd& coefficients) const {
    return 1.0 + mean + (components * coefficients).array();
  }
};

// Which measurements one describes: the light that the skin's surface reflects was seen with the
// rest, as by most spectrophotometers, or is missing, as behind crossed polarisers.
enum class SurfaceLight { included, removed };

// "included", "removed".
std::string surfaceLightName(SurfaceLight surface);
std::optional<SurfaceLight> surfaceLightByName(const std::string& name);

// The discrepancies of both kinds of measurements; none where it was not learned.
struct Discrepancies {
  std::optional<Discrepancy> surfaceIncluded;
  std::optional<Discrepancy> surfaceRemoved;

  const Discrepancy* of(SurfaceLight surface) const {
    const auto& one = surface == SurfaceLight::included ? surfaceIncluded : surfaceRemoved;
    return one ? &*one : nullptr;
  }
  bool empty() const { return !surfaceIncluded && !surfaceRemoved; }
};

// Finite numbers of matching sizes; 1 to kMaximumCoefficients coefficients whose covariance is
// symmetric and positive definite; an independent deviation of 0 or more; no reflectance that could
// fall below a twentieth of the model's within kMostCoefficientNorm; a proper prior. `prefix`
// stands in front of field names.
Status validate(const Discrepancy& discrepancy, const std::string& place,
                const std::string& prefix);

}  // namespace cutis
