#pragma once  // internal to core/skin/free

// Reflectance of a profile's two layers where the thickness of the epidermis is free, too, in
// double precision, with all three derivatives.
//
// Diffusion is exact. Radiative transfer is a polynomial of the logarithm of the thickness through
// tables of kThicknessPoints thicknesses: against a table made for a thickness within 1e-5 rms
// over the parameter box and 5e-5 at worst (see the tests). Thread-safe: const after
// construction.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/maths/chebyshev_weights.h"
#include "core/skin/layers/polynomial.h"
#include "core/skin/profile/free_constants.h"
#include "core/skin/profile/profile.h"

namespace cutis {

inline constexpr int kThicknessPoints = 12;

// `count` skins: thickness in mm, [skin]; absorptions in mm⁻¹, finite and not negative,
// [sample][skin].
struct LayerStates {
  const double* thicknessMm = nullptr;
  const double* epidermalAbsorption = nullptr;
  const double* dermalAbsorption = nullptr;
  std::size_t count = 0;
};

// [sample][skin]; the derivatives, in mm and mm⁻¹, are all there or all empty.
struct LayerSpectra {
  std::vector<double> reflectance, perEpidermalAbsorption, perDermalAbsorption, perThickness;
};

class FreeLayers {
 public:
  // samples: positions on the wavelength grid. Absorptions are covered over the profile's box, at
  // any oxygenation where that is free. A thickness that is not free is the profile's, whatever is
  // asked for. About 24 ms a sample for radiative transfer with a free thickness, on one core; the
  // bits do not depend on the number of cores; fewer thicknessPoints cost and hold in proportion
  // less. Errors: those of thicknessRange() where thickness is
  // free, and of LayerTable::make. Precondition: validate(profile) passed.
  static Result<FreeLayers> make(const Profile& profile, std::span<const int> samples,
                                 const FreeConstants& free, const JobContext& context = {},
                                 int thicknessPoints = kThicknessPoints);

  // Precondition: thicknesses lie in thicknessRange(). A skin's values are its own, whatever the
  // others are.
  LayerSpectra evaluate(const LayerStates& states, bool derivatives) const;

 private:
  FreeLayers(const Profile& profile, std::span<const int> samples, ChebyshevWeights weights);
  void diffuse(const LayerStates& states, LayerSpectra& spectra) const;
  void transfer(const LayerStates& states, LayerSpectra& spectra) const;

  double ownThicknessMm_;
  bool free_ = false;
  double airFactor_;
  std::vector<double> epidermalScattering_, dermalScattering_;  // at the samples
  ChebyshevWeights ofThickness_;                                // in its logarithm
  std::vector<LayerPolynomial<double>> tables_;  // [point][sample]; empty for diffusion
};

}  // namespace cutis
