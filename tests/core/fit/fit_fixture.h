#pragma once

// What the tests of fitting share: the table of the monitor rig, simulated pixels, and the
// objective of the fit written down once more, the plain way.

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/fit/fit_options.h"
#include "core/fit/pixel_solver.h"
#include "core/fit/table/table_search.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis::test {

std::shared_ptr<const SkinModel> sharedModel();
std::shared_ptr<const SkinTable> monitorTable();
std::shared_ptr<const TableSearch> monitorSearch();

// Pixels to solve: [channel][count].
struct PixelSet {
  std::size_t count = 0;
  std::vector<float> channels;

  std::size_t channelCount() const { return channels.size() / count; }
  PixelRows<const float> rows() const { return packedRows(channels.data(), channelCount(), count); }
  Eigen::VectorXd at(std::size_t pixel) const;
};

// The channels of exact spectra with multiplicative Gaussian noise (error protocol,
// resources/manual/accuracy.md).
PixelSet simulate(const Rig& rig, const std::vector<ParameterVector>& people, double noise = 0.0);
// The first channels.size() values are the channels of one pixel, and so on.
PixelSet pixelsOf(const std::vector<std::vector<float>>& pixels);

struct Solutions {
  std::vector<float> parameters;  // [parameter][count]
  std::vector<PixelState> states;
  std::vector<std::uint16_t> iterations;

  ParameterVector at(std::size_t pixel) const;
  PixelRows<const float> rows() const {
    return packedRows(parameters.data(), kParameterCount, states.size());
  }
  bool operator==(const Solutions&) const = default;
};
Solutions solve(const PixelSolver& solver, const PixelSet& pixels);

// Mean squared error of reflectance over 400–700 nm.
double visibleError(const ParameterVector& a, const ParameterVector& b);

// A linear prior: mean and spread of the error protocol's uniform population.
Prior populationPrior();

// Σ (y − f(x))² / σ² + Σ (x − μ)² / s², see core/fit/reference/map_estimator.h.
struct Objective {
  const SkinModel& model;
  SpectralNodes nodes;
  std::optional<Prior> prior;
  NoiseModel noise;

  // Logarithms where the prior is.
  ParameterVector coordinates(const ParameterVector& parameters) const;
  ParameterVector parameters(const ParameterVector& coordinates) const;
  Eigen::VectorXd modelled(const ParameterVector& parameters) const;
  double cost(const Eigen::VectorXd& channels, const ParameterVector& parameters) const;
  // Inverse of Jᵀ Σ⁻¹ J + P⁻¹ with numerical derivatives, in coordinates.
  Eigen::Matrix<double, 5, 5> covariance(const Eigen::VectorXd& channels,
                                         const ParameterVector& parameters) const;
};

}  // namespace cutis::test
