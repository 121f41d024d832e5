#pragma once  // internal to src/cli/commands/validate

#include <string>
#include <vector>

#include "core/evaluate/validation.h"
#include "src/report/drawing.h"

namespace cutis {

// Residual spectra of a profile on a set of spectra: mean and spread by wavelength, dark, middle
// and light skin each in a panel of its own, all to one scale. measurement: how the spectra were
// measured, in words.
Drawing validationPlot(const ValidationFigures& figures, const std::vector<double>& wavelengthsNm,
                       const std::string& profile, const std::string& data,
                       const std::string& measurement);

}  // namespace cutis
