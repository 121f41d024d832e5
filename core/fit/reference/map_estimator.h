#pragma once

// Maximum a posteriori estimate of one pixel's parameters, in double precision: the plain version
// that the fast solver is held against, and the solver for measured spectra.
//
// Minimises  Σ_k (y_k − f_k(x))² / σ_k²  +  Σ_i (x_i − μ_i)² / s_i²  over the box, by Levenberg's
// damped Gauss–Newton steps with an active set. f are weighted sums of reflectances at nodes;
// σ_k² = read² + (proportional · y_k)², read at least kExactNoise (core/fit/assumed_noise.h). A
// concentration with a log-normal prior is estimated as its logarithm. Without a prior only the
// first sum remains, in linear coordinates.

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/rig/rig.h"
#include "core/skin/model/instrument_model.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/prior.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

struct EstimatorOptions {
  std::optional<Prior> prior;  // none: bounded least squares
  NoiseModel noise;
  // Parameters held at a value instead of being estimated.
  std::array<std::optional<double>, kParameterCount> fixed = {};
  int maximumIterations = 200;
  MeasurementGeometry geometry = {};  // how the channels see the skin
};

struct Estimate {
  ParameterVector parameters = ParameterVector::Zero();
  // Posterior standard deviations in the parameters' units; 0 for fixed ones.
  ParameterVector deviations = ParameterVector::Zero();
  // Posterior covariance in the coordinates of the estimate (logarithms where the prior is).
  ParameterMatrix covariance = ParameterMatrix::Zero();
  // Measured minus modelled.
  Eigen::VectorXd residual;
  double cost = 0.0;  // the minimised sum
  int iterations = 0;
  bool converged = false;
};

// Thread-safe: const after construction.
class MapEstimator {
 public:
  // nodes: rows × nodes. Rows with zero weight throughout (a dead channel) are ignored.
  MapEstimator(const SkinModel& model, SpectralNodes nodes, const EstimatorOptions& options);

  // From the prior's mean (the middle of the box without a prior), or from a given start, which is
  // clamped into the box.
  Estimate solve(const Eigen::VectorXd& channels) const;
  Estimate solve(const Eigen::VectorXd& channels, const ParameterVector& start) const;

 private:
  struct Linearisation {
    Eigen::VectorXd modelled;
    Eigen::Matrix<double, Eigen::Dynamic, kParameterCount> jacobian;  // d modelled / d coordinate
  };

  bool isLog(int parameter) const { return options_.prior && options_.prior->isLog(parameter); }
  double coordinate(int parameter, double value) const;
  ParameterVector parametersAt(const ParameterVector& coordinates) const;
  Linearisation linearise(const ParameterVector& coordinates) const;
  double cost(const Eigen::VectorXd& channels, const Eigen::VectorXd& precision,
              const ParameterVector& coordinates) const;

  ParameterVector stepWithinBox(const ParameterMatrix& hessian, const ParameterVector& downhill,
                                const ParameterVector& x,
                                std::array<bool, kParameterCount> held) const;

  const SkinModel& model_;
  InstrumentModel instrument_;
  SpectralNodes nodes_;
  EstimatorOptions options_;
  std::vector<bool> alive_;                                   // per row
  ParameterVector low_, high_;                                // box, in coordinates
  ParameterVector priorMean_ = ParameterVector::Zero();       // in coordinates
  ParameterMatrix priorPrecision_ = ParameterMatrix::Zero();  // inverse covariance
};

}  // namespace cutis
