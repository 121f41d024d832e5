#pragma once  // internal to core/calibrate

// Spectra of people from what the channels of a rig see of them, plain and in double precision: to
// judge a discrepancy by.
//
// Coordinates and coefficients are the most probable ones together; a discrepancy is as wide in
// the channels as it is for skin like the prior's mean.

#include <optional>

#include <Eigen/Core>

#include "core/calibrate/discrepancy/coordinate_search.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/discrepancy.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

// Thread-safe: const after construction.
class ChannelEstimator {
 public:
  // rows: of channels, each sums to 1. noise: relative, positive. The model outlives it.
  ChannelEstimator(const SkinModel& model, const SpectrumRows& rows, double noise,
                   const Prior& prior, const std::optional<Discrepancy>& discrepancy);

  Spectrum reflectance(const Eigen::VectorXd& channels) const;  // channels: positive

 private:
  CoordinateEquations equations(const Eigen::VectorXd& channels,
                                const Coordinates& coordinates) const;
  Eigen::VectorXd residual(const Eigen::VectorXd& channels, const Coordinates& coordinates) const;

  const SkinModel& model_;
  Prior like_;
  CoordinatePrior prior_;
  std::optional<Discrepancy> discrepancy_;
  SpectralNodes nodes_;         // of the rows, with the discrepancy's mean
  Eigen::MatrixXd components_;  // relative, [channel][coefficient]
  Eigen::MatrixXd slopes_;      // relative, [channel][parameter]
  Eigen::MatrixXd precision_;   // of relative channels
};

}  // namespace cutis
