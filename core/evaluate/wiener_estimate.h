#pragma once

// The Wiener estimate of spectra from channels: what multispectral imaging of skin uses where it
// knows no physics, and so what physics has to beat.
//
//   spectrum = mean spectrum + C_sf (C_ff + N)⁻¹ (f − mean f)
//
// f are features of the channels: these alone, or these with their squares and products. C_ff and
// C_sf are covariances over the training spectra; N is diagonal and holds the variance of each
// feature that comes from the noise of the channels, mean over the training spectra, which makes it
// ridge regression (Pratt & Mancill 1976; Haneishi et al. 2000).
//
// Reflectances are shares of the perfect diffuser. A NaN among the training spectra makes NaN of
// the estimates at that wavelength alone. Thread-safe: const after construction.

#include <Eigen/Core>

#include "core/rig/rig.h"

namespace cutis {

enum class WienerFeatures {
  channels,           // the linear estimate
  channelsAndSquares  // the quadratic one
};

class WienerEstimate {
 public:
  // channels: [channel][spectrum] without noise; spectra: [wavelength][spectrum]. Noise of less
  // than kExactNoise counts as that much, so that the covariance can be inverted. Preconditions: at
  // least two spectra, finite channels.
  WienerEstimate(WienerFeatures features, const Eigen::MatrixXd& channels,
                 const Eigen::MatrixXd& spectra, const NoiseModel& noise);

  // [channel][spectrum] → [wavelength][spectrum]
  Eigen::MatrixXd estimate(const Eigen::MatrixXd& channels) const;

 private:
  WienerFeatures features_;
  Eigen::VectorXd meanFeatures_;
  Eigen::VectorXd meanSpectrum_;
  Eigen::MatrixXd gain_;  // [wavelength][feature]
};

}  // namespace cutis
