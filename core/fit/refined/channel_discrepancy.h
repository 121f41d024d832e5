#pragma once  // internal to core/fit/refined

// The discrepancy of a profile (core/skin/profile/discrepancy.h) as channels see it, in the
// coordinates of a fit.
//
// Where a pixel measures y, the discrepancy adds y (offset + slope · x) to the modelled channels
// with the covariance y yᵀ ∘ covariance. How much of a spectrum's change a channel sees depends
// little on the spectrum, so that shares at the prior's mean do for all pixels. Relative, no unit.

#include <Eigen/Core>

#include "core/fit/coordinate_prior.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/discrepancy.h"
#include "core/spectra/grid.h"

namespace cutis {

struct ChannelDiscrepancy {
  Eigen::VectorXd offset;          // [channel]
  Eigen::MatrixXd slope;           // [channel][coordinate]; 0 for those that are held
  Eigen::MatrixXd perCoefficient;  // [channel][coefficient]
  Eigen::MatrixXd covariance;      // [channel][channel], of the channels at given coordinates
  // Coefficients = coefficientOffset + coefficientSlope · x + gain · (y ∘ Σ⁻¹ residual), with the
  // residual measured minus modelled, the offset and slope above included, and Σ its covariance.
  Eigen::VectorXd coefficientOffset;
  Eigen::MatrixXd coefficientSlope;  // [coefficient][coordinate]
  Eigen::MatrixXd coefficientCovariance;
  Eigen::MatrixXd gain;  // [coefficient][channel]

  bool empty() const { return gain.size() == 0; }
  int count() const { return static_cast<int>(gain.rows()); }
};

// rows: responses of the channels over the grid, 0 throughout for one that sees nothing.
ChannelDiscrepancy channelDiscrepancy(const Discrepancy& discrepancy, const SkinModel& model,
                                      const SpectrumRows& rows, const CoordinatePrior& coordinates);

}  // namespace cutis
