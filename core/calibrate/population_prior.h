#pragma once  // internal to core/calibrate

// What a population is like, from spectra of its members: the prior of a profile.
//
// Expectation maximisation of a normal distribution of the prior's coordinates (logarithms where it
// has them): each round every person is estimated under the prior of the round before, and the new
// mean and covariance are those of the estimates, with their posterior covariances added, so that
// what spectra do not determine does not shrink the spread (Dempster, Laird & Rubin 1977).

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/calibrate/calibration.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

// spectra: used from kFittedFromNm to kFittedToNm; more than parameters. noise: standard deviation
// of every reflectance, what the model leaves out included; positive. start: where to begin; its
// scale and what stays linear are kept. 20 rounds; 3 ms a spectrum on one core. Cancelled or out of
// memory, or an error if the population has no spread in some parameter. Same result for any number
// of threads.
Result<Prior> populationPrior(const SkinModel& model, const MeasurementGeometry& geometry,
                              const SpectraSet& spectra, double noise, const Prior& start,
                              const JobContext& context);

}  // namespace cutis
