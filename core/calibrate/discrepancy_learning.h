#pragma once

// What a model leaves over of measured skin, learned from spectra of people
// (core/skin/profile/discrepancy.h), with the prior of the same people beside it.
//
// Everyone is fitted to the spectrum as a whole, with the discrepancy of the round before as
// correlated noise (to begin with a smooth Gaussian process), so that parameters follow what they
// can explain and nothing else. What is left over, relative to the model, has a mean, follows the
// parameters' coordinates by ridge regression, and varies about that with a covariance that is
// drawn towards the smooth one by a few people's worth. Fits begin at 320 nm; below, what is left
// over is as measured. People whose fit comes to no end do not count, and those far from all others
// count for less.
//
// The components are those of the greatest variance of reflectance over the wavelengths that
// cameras see; outside of these each is what goes with it. What remains is `rest`: eight spectra,
// and an independent deviation for what these leave out of the variance. At every wavelength that
// was measured it is at least as wide as what people have who are left out one by one and told from
// what was learned of all others.
//
// Wavelengths are positions on the grid, reflectances shares as measured. Thread-safe: a pure
// function; the same result for any number of threads.

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/calibrate/calibration.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

struct DiscrepancyLearning {
  // How many components; at most kMaximumCoefficients, and fewer than there are spectra.
  int components = 6;
  // What the learned prior is drawn towards, by a few people's worth; also where fits begin.
  Prior prior;
  // Light that the instrument's aperture loses (core/skin/model/measurement_geometry.h): part of
  // how it measures, and of no one's skin.
  double edgeLossPerMm = 0.0;
};

// The fewest people of whom anything is learned.
inline constexpr int kFewestPeople = 8;

// spectra: at least kFewestPeople, positive, at samples that reach at least from 400 to 700 nm;
// outside of what was measured the discrepancy is the smooth process alone, given what was. The
// surface's reflection must have been taken off already where SurfaceLight::removed is meant. Aims
// are not used. A second for fifty people. Cancelled if asked to stop; errors: too few people, a
// reflectance that is not positive.
Result<Discrepancy> learnDiscrepancy(const SkinModel& model, const SpectraSet& spectra,
                                     const DiscrepancyLearning& options, const JobContext& context);

}  // namespace cutis
