#pragma once

// Measured spectra photographed by arithmetic, fitted as photographs are, and compared with what
// was measured: the yardstick for spectra that come from a few channels.
//
// Spectra are [wavelength][spectrum], channels [channel][spectrum], reflectances shares of the
// perfect diffuser; NaN stands for what is not known. Errors are root mean squares of reflectance
// over the wavelengths of one person, ends included. Thread-safe: pure functions; the same result
// for any number of threads.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/evaluate/validation.h"
#include "core/fit/fit_options.h"
#include "core/rig/rig.h"
#include "core/skin/model/measurement_geometry.h"
#include "core/skin/model/skin_model.h"
#include "core/spectra/measured_spectra.h"

namespace cutis {

// Where photographs are compared with what was measured.
inline constexpr std::array<WavelengthRange, 3> kCaptureRanges = {kFittedRange, kUltravioletRange,
                                                                  kNearInfraredRange};

// The rig, blind beyond a range: what was not measured cannot be photographed. Precondition: the
// range has a part of every channel, or a channel becomes one that sees nothing.
Rig rigWithin(const Rig& rig, const WavelengthRange& range);

// Channels of all spectra, from which the geometry's surface reflection was taken, times
// 1 + noise · n with n normal and independent, drawn by the key; never negative.
Eigen::MatrixXd photographSpectra(const Rig& rig, const MeasuredSpectra& spectra,
                                  const MeasurementGeometry& geometry, double noise,
                                  std::uint64_t key);

// The spectra at other wavelengths: linear between those that were measured, NaN beyond them.
Eigen::MatrixXd resampled(const MeasuredSpectra& spectra, std::span<const double> wavelengthsNm);

struct EstimatedSpectra {
  Eigen::MatrixXd reflectance;
  // Standard deviation of the estimate; of no size where the estimator has none.
  Eigen::MatrixXd deviation;
};

// The refined fit of some of the photographs, as SpectrumPosterior says spectra and deviations of
// it, seen through the geometry; NaN for the others. Precondition: options.method is refined, and
// nothing is free. Cancelled if asked to stop.
Result<EstimatedSpectra> fitPhotographs(const std::shared_ptr<const SkinModel>& model,
                                        const Rig& rig, const FitOptions& options,
                                        const Eigen::MatrixXd& channels,
                                        std::span<const std::size_t> spectra,
                                        const MeasurementGeometry& geometry,
                                        std::span<const double> wavelengthsNm,
                                        const JobContext& context);

// Whom spectra are of: those that are called the same are one person's. [person][spectrum], in the
// order in which people appear.
std::vector<std::vector<std::size_t>> peopleOf(const MeasuredSpectra& spectra);

// The people in order of mean reflectance from 400 to 700 nm: which of kToneThirds each belongs to.
std::vector<std::size_t> toneThirdsOf(const MeasuredSpectra& spectra,
                                      std::span<const std::vector<std::size_t>> people);

// Over people; NaN where nothing was measured or estimated.
struct CaptureFigures {
  CaptureFigures();

  double median, within95, worst;
  // The share of wavelengths at which two deviations hold what was measured.
  double coverage;
};

// Some of the people over a range; spectra with a person's index are all of theirs.
CaptureFigures captureFigures(const WavelengthRange& range, const MeasuredSpectra& spectra,
                              const EstimatedSpectra& estimated,
                              std::span<const std::vector<std::size_t>> people);

// The median over people of the error at each wavelength.
std::vector<double> medianErrors(const MeasuredSpectra& spectra, const EstimatedSpectra& estimated,
                                 std::span<const std::vector<std::size_t>> people);

}  // namespace cutis
