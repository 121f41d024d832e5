#pragma once  // internal to core/analyse

// What a rig can tell apart: how far a measurement narrows what is known of a person's skin.
//
// For each person the posterior covariance C = (Jᵀ Σ⁻¹ J + P⁻¹)⁻¹ of the coordinates (logarithms
// where the prior has them), J the channels' derivatives, Σ the noise, P the prior's covariance;
// and what it leaves open of the spectrum, diag(G C Gᵀ) (error protocol,
// resources/manual/accuracy.md). Thread-safe.

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/prior.h"

namespace cutis {

// Channels as they are measured: rows over the grid, each with noise of its own.
struct ChannelSet {
  SpectrumRows rows;
  NoiseModel noise;  // not exact
  // What is made of them before anything is estimated, one combination a row; empty: nothing.
  Eigen::MatrixXd combination;
};

struct Spread {
  double low = 0.0, median = 0.0, high = 0.0;  // 5, 50 and 95 of 100 people are below
};

struct Identifiability {
  // Posterior over prior deviation: 0 is known, 1 is guessed.
  std::array<Spread, kParameterCount> left;
  // The share of people for whom the measurement at least halves the prior's deviation.
  std::array<double, kParameterCount> decidedShare = {};
  // Root mean square deviation of the predicted reflectance.
  double visible = 0.0;       // 400–700 nm
  double ultraviolet = 0.0;   // 300–400 nm
  double nearInfrared = 0.0;  // 700–1000 nm
};

// People in front of measurements that are yet to be chosen: their spectra and derivatives are
// computed once.
class IdentifiabilityStudy {
 public:
  // prior: with which anything is estimated; people: in front of the camera, some. About 0.1 ms a
  // person and core, and 28 KB.
  static Result<IdentifiabilityStudy> create(const SkinModel& model, const Prior& prior,
                                             std::span<const ParameterVector> people,
                                             const JobContext& context);

  // Channels that see nothing are left out. About 20 µs a person.
  Identifiability of(const ChannelSet& channels) const;

 private:
  using Derivatives = Eigen::Matrix<double, kSampleCount, kParameterCount>;

  std::vector<Spectrum> reflectances_;
  std::vector<Derivatives> derivatives_;  // with respect to the coordinates
  ParameterMatrix priorPrecision_;
  ParameterVector priorDeviation_;
};

}  // namespace cutis
