#pragma once

// Bounded least squares as in core/fit/spectra/spectra_fit.h, with the oxygenation of blood or the
// thickness of the epidermis, or both, found for each spectrum beside the five parameters.
//
// Oxygenation lies in 0 to 1, thickness in thicknessRange() of the profile. There is no prior:
// where a spectrum cannot separate them from the parameters, they end wherever the misfit is
// lowest, at a bound as a rule. Never a larger misfit than with the profile's own constants, but
// for the error of core/skin/free/free_layers.h. A result depends on its own spectrum alone and is
// the same for any number of threads.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/spectra/spectra_fit.h"
#include "core/skin/profile/free_constants.h"

namespace cutis {

// Fewer wavelengths than there are numbers to find determine nothing.
std::size_t fewestWavelengths(const FreeConstants& free);

struct FreeSpectrumFit {
  SpectrumFit fit;
  SkinConstants constants;  // what is not free is the profile's
};

// As fitSpectra(), of which it gives the result where nothing is free; at least fewestWavelengths()
// wavelengths. Errors beside those of fitSpectra(): those of FreeLayers::make. At 31
// wavelengths a spectrum takes one core about 4 ms by diffusion; by radiative transfer 2 ms with
// oxygenation alone, 9 ms with a thickness.
Result<std::vector<FreeSpectrumFit>> fitSpectraFreely(const SkinModel& model,
                                                      std::span<const double> wavelengthsNm,
                                                      std::span<const double> reflectances,
                                                      const FreeConstants& free,
                                                      const JobContext& context,
                                                      const MeasurementGeometry& geometry = {});

}  // namespace cutis
