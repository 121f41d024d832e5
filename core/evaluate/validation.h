#pragma once

// How well a profile's skin is measured skin: fitted to the visible part of spectra, what it says
// of that part and predicts of the rest; and what it predicts from a colour alone.
//
// Errors are root mean squares of reflectance over the wavelengths of one spectrum, ends included.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/skin/model/measurement_geometry.h"
#include "core/skin/model/skin_model.h"
#include "core/spectra/measured_spectra.h"

namespace cutis {

inline constexpr WavelengthRange kFittedRange = {400.0, 700.0};
inline constexpr WavelengthRange kUltravioletRange = {320.0, 400.0};
inline constexpr WavelengthRange kNearInfraredRange = {700.0, 1000.0};

// Of the spectra's errors; NaN where the spectra do not reach.
struct ErrorDistribution {
  ErrorDistribution();

  double mean, median, within95, most;
};
// NaN for no errors.
ErrorDistribution distributionOf(std::vector<double> errors);

// Modelled minus measured reflectance over some of the spectra, by wavelength.
struct ToneResiduals {
  std::size_t spectra = 0;
  double darkest = 0.0, lightest = 0.0;  // mean reflectance, 400–700 nm
  std::vector<double> mean;
  std::vector<double> deviation;  // standard deviation between spectra
};

inline constexpr std::size_t kToneThirds = 3;

struct ValidationFigures {
  ErrorDistribution fitted;        // 400–700 nm
  ErrorDistribution ultraviolet;   // predicted from that fit
  ErrorDistribution nearInfrared;  // the same
  // 400–700 nm, predicted from the colour: the most probable skin under the profile's prior. NaN
  // unless the spectra reach from 400 to 700 nm.
  ErrorDistribution fromColor;
  // The spectra in order of mean reflectance from 400 to 700 nm: dark, middle and light third.
  std::array<ToneResiduals, kToneThirds> tones;
};

// The part of a range that is measured; nothing if that is no more than what is fitted.
std::optional<WavelengthRange> measuredPart(const MeasuredSpectra& spectra,
                                            const WavelengthRange& range);

// spectra: within the grid, at least kFewestWavelengths of kFittedRange. rig: what sees the colour,
// within the wavelengths that were measured; its noise is the colour's.
// Preconditions: validate(geometry) and validate(rig) passed. Fails only when cancelled or out of
// memory.
Result<ValidationFigures> validateModel(const SkinModel& model, const MeasuredSpectra& spectra,
                                        const MeasurementGeometry& geometry, const Rig& rig,
                                        const JobContext& context);

}  // namespace cutis
