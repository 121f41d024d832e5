#pragma once

// The constants of a profile from measured spectra: those with which skin that was fitted to the
// visible part of a spectrum predicts the rest of it, too.
//
// For any constants c each spectrum has its own five parameters p(c), those that come closest to it
// from kFittedFromNm to kFittedToNm within the profile's ranges. The constants minimise
//
//   Σ_aims (rms of modelled(c, p(c)) − measured, over the aim's wavelengths and the set's spectra)²
//          / aim²  +  pull · Σ_j ((c_j − expected_j) / deviation_j)²
//
// where the second sum keeps constants that the spectra hardly determine near what is known of
// them. Damped Gauss–Newton over c with p eliminated (variable projection: Golub & Pereyra 1973, in
// the form of Kaufman 1975); derivatives by constants are differences.
//
// Wavelengths are positions on the grid, reflectances shares as measured. Thread-safe: pure
// functions; the result is the same for any number of threads.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/model/measurement_geometry.h"
#include "core/skin/profile/profile.h"

namespace cutis {

inline constexpr double kFittedFromNm = 400.0;
inline constexpr double kFittedToNm = 700.0;

// An error that would do, over a range of wavelengths with both ends.
struct SpectralAim {
  double fromNm = kFittedFromNm;
  double toNm = kFittedToNm;
  double rms = 0.0;  // positive
};

// Spectra that were measured alike, finite.
struct SpectraSet {
  std::vector<int> samples;  // increasing positions on the grid
  Eigen::ArrayXXd measured;  // [sample][spectrum]
  std::vector<SpectralAim> aims;

  Eigen::Index count() const { return measured.cols(); }
};

// Some of a set's spectra, in the order given; one may come several times.
SpectraSet selected(const SpectraSet& set, std::span<const std::size_t> spectra);

struct CalibratedConstant {
  std::string name;
  double low = 0.0, high = 0.0;  // bounds, low < high
  double expected = 0.0;
  double deviation = 1.0;  // positive
  // Whether deviation is that of the natural logarithm; then low and expected are positive.
  bool isLog = false;
};

// What constants make: the profile, and how each set sees it.
struct CalibrationPoint {
  Profile profile;
  std::vector<MeasurementGeometry> geometries;
};

struct CalibrationProblem {
  std::vector<SpectraSet> sets;
  std::vector<CalibratedConstant> constants;
  double pull = 0.0;
  // Constants within their bounds → point, with a geometry per set. Called from one thread. Its
  // errors end the calibration.
  std::function<Result<CalibrationPoint>(std::span<const double>)> pointAt;
};

struct Calibration {
  std::vector<double> constants;
  double cost = 0.0;  // the minimised sum
  int rounds = 0;
  bool converged = false;
};

// Begins at a start within the bounds. Preconditions: as stated above; each set has spectra and at
// least kParameterCount samples in the fitted range. Cancelled if asked to. About 1 s a round and
// thousand spectra on one core, and what the layer tables of a round take.
Result<Calibration> calibrate(const CalibrationProblem& problem, const std::vector<double>& start,
                              const JobContext& context);

}  // namespace cutis
