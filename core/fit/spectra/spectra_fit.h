#pragma once

// Bounded least squares: the parameters whose spectrum comes closest to a measured one.
//
// Minimises the root mean square over the measured wavelengths of measured minus modelled
// reflectance, within the profile's ranges and without a prior. Between two samples of the grid the
// model is interpolated linearly. The misfit hardly changes along a valley of the parameters, so a
// search ends when nothing is left to gain in misfit, not when the parameters stand still: spectra
// are known far better than the parameters that make them (see core/skin/profile/prior.h).
//
// From each spectrum's own nearest samples of the box a damped Gauss–Newton search with bounds is
// run in double precision, and the best end is kept: the misfit is that of many random starts
// within 1e-5. A result depends on its own spectrum alone and is the same for any number of
// threads.

#include <span>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/model/measurement_geometry.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

// Fewer wavelengths than parameters determine nothing.
inline constexpr std::size_t kFewestWavelengths = kParameterCount;

// More further chromophores than this are refused.
inline constexpr std::size_t kMostFurther = 2;

struct SpectrumFit {
  // Where there is no melanin its blend has no meaning and is 0.
  ParameterVector parameters = ParameterVector::Zero();
  double rmse = 0.0;
  // Amounts of the profile's further chromophores.
  std::vector<double> further;
};

// wavelengthsNm: strictly increasing, within the grid, at least kFewestWavelengths and one more for
// each further chromophore.
// reflectances: [spectrum][wavelength], shares from 0 to 1, finite, as `geometry` measures them;
// the RMSE is of them. Precondition: validate(geometry) passed.
// One result per spectrum, in order. Fails when cancelled or out of memory, or for a profile with
// more than kMostFurther further chromophores. About 0.3 ms a spectrum and core at 31 wavelengths,
// in proportion to their number; several times that with edge loss or a further chromophore.
Result<std::vector<SpectrumFit>> fitSpectra(const SkinModel& model,
                                            std::span<const double> wavelengthsNm,
                                            std::span<const double> reflectances,
                                            const JobContext& context,
                                            const MeasurementGeometry& geometry = {});

}  // namespace cutis
