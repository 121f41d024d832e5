#pragma once

// A calibration, and how far it can be believed: the constants with their intervals, the prior of
// the people measured, and how well the profile does on spectra that were left out.
//
// Intervals come from calibrations on spectra drawn again with replacement; errors on spectra left
// out from halving the spectra at random, calibrating on one half and judging on the other.
// Deterministic by the seed, for any number of threads. Errors of reflectance are those of
// core/evaluate/validation.h.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/calibrate/calibration.h"
#include "core/rig/rig.h"
#include "core/skin/model/measurement_geometry.h"
#include "core/skin/profile/prior.h"
#include "core/skin/profile/profile.h"
#include "core/spectra/measured_spectra.h"

namespace cutis {

// Spectra that were measured alike.
struct StudiedSpectra {
  MeasuredSpectra spectra;
  SpecularPart specular = SpecularPart::excluded;
  double specularShare = 0.0;  // as the study begins
  double edgeLossPerMm = 0.0;
  std::vector<SpectralAim> aims;
};

struct StudiedConstant {
  CalibratedConstant constant;
  double start = 0.0;
  std::optional<std::size_t> spectra;  // whose specular share it is; none: one of the profile
};

struct CalibrationStudy {
  std::vector<StudiedSpectra> spectra;
  std::vector<StudiedConstant> constants;
  // All constants, [constant] → the profile that has those of them that are its own. Called from
  // one thread; its errors end the study.
  std::function<Result<Profile>(std::span<const double>)> profileAt;
  int stepNm = 10;               // distance of the wavelengths compared, a multiple of the grid's
  double pull = 0.0;             // as in CalibrationProblem
  std::size_t priorSpectra = 0;  // whom the prior is found from
  double priorNoise = 0.0;       // standard deviation of measured minus modelled, positive
  Rig colorRig;                  // what sees the colours of validateModel()
  int halvings = 0;              // from 0
  int bootstraps = 0;            // from 0
  std::uint64_t seed = 1;
};

struct ConstantFigures {
  double value = 0.0;            // rounded: the spectra determine no more digits
  double low = 0.0, high = 0.0;  // 5 and 95 % of the bootstraps; NaN without
};

// Mean RMSE over some range, of the spectra calibrated on and of those left out.
struct CalibrationError {
  double all = 0.0;                   // NaN where the spectra do not reach
  double leftOut = 0.0, worst = 0.0;  // mean and greatest over the halves; NaN without
};

// What is judged of each set: the fit, and what is predicted from it or from a colour.
enum class JudgedRange { fitted, ultraviolet, nearInfrared, fromColor };
inline constexpr std::size_t kJudgedRangeCount = 4;

struct CalibrationFigures {
  std::vector<ConstantFigures> constants;
  std::vector<std::array<CalibrationError, kJudgedRangeCount>> errors;  // [set][JudgedRange]
  Prior prior;  // of the calibrated profile, in a few digits
};

// Preconditions: each set has spectra and reaches over its aims and from kFittedFromNm to
// kFittedToNm; with halvings at least four spectra a set. Errors: those of profileAt, of
// populationPrior() and of a layer table; cancelled if asked to stop. About 3 s a calibration of
// 4000 spectra on two cores and as much for each halving and bootstrap, besides validation.
Result<CalibrationFigures> runStudy(const CalibrationStudy& study, const JobContext& context);

}  // namespace cutis
