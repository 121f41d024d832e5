#pragma once

// The Bayesian Cramér–Rao bound of the error protocol: what no estimate can beat on average, as far
// as the population is normal.
//
//   mean over the people of diag(G C Gᵀ) over the band,  C = (Jᵀ Σ⁻¹ J + P⁻¹)⁻¹,
//
// J and G the Jacobians of channels and spectrum, Σ the noise, P diagonal with the prior's
// variances (resources/manual/accuracy.md). The box the parameters live in adds information that
// the bound does not count, so that a fit may come out a little below it.

#include <span>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/prior.h"

namespace cutis {

// Mean squared errors of reflectance, perfect diffuser = 1.
struct ErrorBound {
  double visible = 0.0;       // 400–700 nm
  double ultraviolet = 0.0;   // 300–400 nm
  double nearInfrared = 0.0;  // 700–1000 nm
};

// One bound per noise, each a proportional standard deviation above 0. prior: linear. Channels that
// see nothing are left out. All zero for no people. About 0.1 ms a person and core. Cancelled if
// asked to stop.
Result<std::vector<ErrorBound>> errorBounds(const SkinModel& model, const Rig& rig,
                                            std::span<const ParameterVector> people,
                                            const Prior& prior, std::span<const double> noises,
                                            const JobContext& context);

}  // namespace cutis
