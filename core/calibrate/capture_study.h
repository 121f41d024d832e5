#pragma once

// How near the fit of photographs comes to measured spectra of people whom it has not seen, and how
// near the Wiener estimate of the same channels does (core/evaluate/capture_validation.h,
// core/evaluate/wiener_estimate.h).
//
// A model keeps its constants; what it leaves over of measured skin, and the prior of the people,
// are learned again (core/calibrate/discrepancy_learning.h) from half of the people, drawn at
// random, and judged on the other half, both ways; or from all people but a part, part after part;
// or learned from one set and judged on another. Wiener estimates are trained on the same spectra.
// Where there are more than kMostLearned people, as many are drawn to learn from.
//
// Figures of halves are the means over the halves; those of parts are of all people at once.
// Deterministic by the seed, for any number of threads.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/evaluate/capture_validation.h"
#include "core/rig/rig.h"
#include "core/skin/model/measurement_geometry.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/discrepancy.h"
#include "core/spectra/measured_spectra.h"

namespace cutis {

inline constexpr std::size_t kMostLearned = 200;

// A model and how it sees the spectra: the geometry's surface reflection is taken off them before
// they are photographed, and added to what is compared with them.
struct StudiedModel {
  std::shared_ptr<const SkinModel> model;
  MeasurementGeometry geometry;
};

struct CaptureStudy {
  std::vector<MeasuredSpectra> sets;
  std::vector<StudiedModel> models;
  SurfaceLight surface = SurfaceLight::included;  // of the photographs
  Rig rig;
  // Standard deviation of a channel over the channel, from 0. The fit assumes it beside the rig's
  // noise of reading; at 0 it is the exact setting with the discrepancy asked for.
  double noise = 0.0;
  int halvings = 10;  // from 0
  // Into how many parts of equal size, but for one person, the people are divided at random, each
  // of which is judged by what the others teach; 0: not at all.
  int folds = 0;
  std::uint64_t seed = 1;
};

enum class CaptureEstimator { refined, wiener, quadraticWiener };

// What an estimator knows of the people whom it is judged on.
enum class CaptureScheme {
  asShipped,           // the profile as it is
  withoutDiscrepancy,  // the profile, told that it leaves nothing over; where it has a discrepancy
  peopleLeftOut,       // learned from the other half of the set
  foldLeftOut,         // learned from all of the set but the part that they are in
  setLeftOut,          // learned from another set
};

// All people, and the dark, middle and light third of them.
inline constexpr std::size_t kCaptureGroups = 1 + kToneThirds;

struct CaptureResult {
  CaptureEstimator estimator = CaptureEstimator::refined;
  std::size_t model = 0;  // of the refined fit
  CaptureScheme scheme = CaptureScheme::asShipped;
  std::size_t set = 0;          // judged on
  std::size_t learnedFrom = 0;  // with setLeftOut
  std::array<std::array<CaptureFigures, kCaptureRanges.size()>, kCaptureGroups> figures;
  std::vector<double> medianErrors;  // at each wavelength of the set
};

// By set, then by scheme, then refined fits before the others.
//
// Preconditions: at least one set and model; spectra from 400 to 700 nm without a gap, and there
// above the surface reflection; with halvings at least 2 · kFewestPeople people a set, with several
// sets kFewestPeople; folds 0 or from 2 to the people of each set, of whom all but the largest part
// are kFewestPeople at least. Errors: those of learnDiscrepancy(). Cancelled if asked to stop.
// About 0.5 s a half of 25 people and model.
Result<std::vector<CaptureResult>> runCaptureStudy(const CaptureStudy& study,
                                                   const JobContext& context);

}  // namespace cutis
