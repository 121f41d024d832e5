#pragma once

// Principal components of the model's spectra over the table of skin (paper §6.1 and supplement D):
// mean and directions in which a spectrum is described by a few weights,
//
//   R ≈ mean + Σ_j weight_j · component_j,   weight_j = component_j · (R − mean).
//
// Spectra stream through: none are kept. Mean and covariance are summed in double precision in a
// fixed order, so the bytes do not depend on the number of threads (on one instruction set).

#include <cstdint>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/model/skin_model.h"
#include "core/spectra/grid.h"

namespace cutis {

// More than this many are never needed: they leave less than the spectra's own rounding.
inline constexpr int kMaximumComponents = 64;

struct SpectraBasis {
  Spectrum mean = Spectrum::Zero();
  // One per column, kSampleCount × kMaximumComponents, orthonormal, the largest variance first. The
  // entry of largest magnitude in a component is positive.
  Eigen::MatrixXd components;
  // Variances of the weights over the table, decreasing; all kSampleCount of them.
  Eigen::VectorXd variances;
  std::int64_t spectra = 0;  // how many there were

  // Mean squared error of reflectance, over samples and spectra of the table, that the first
  // `count` components leave. count in [0, kSampleCount].
  double truncationError(int count) const;
  // The fewest that leave at most `error`; kMaximumComponents if that many do not.
  int componentsFor(double error) const;
};

// All entries of the profile's table: 572,220 for li2024, which take about 10 s on two cores. A
// larger `stride` takes every stride-th entry only. Cancelled if asked to stop.
Result<SpectraBasis> computeSpectraBasis(const SkinModel& model, const JobContext& context,
                                         int stride = 1);

}  // namespace cutis
