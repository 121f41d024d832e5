#pragma once

// The model at measured wavelengths for many parameter sets at once, and the normal equations of
// their misfit: the inner part of core/fit/spectra_fit.cpp.
//
// In absorptions the model is close to linear, so derivatives are with respect to what absorbs: the
// amounts of eumelanin C_m β_m and pheomelanin C_m (1 − β_m), then dermal and epidermal haemoglobin
// and carotene, each in units of its range (both melanins in units of that of C_m).

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/skin/measured_model.h"
#include "core/skin/node_model.h"
#include "core/skin/skin_model.h"

namespace cutis {

using EquationMatrix = Eigen::Matrix<double, kParameterCount, kParameterCount>;
using EquationVector = Eigen::Matrix<double, kParameterCount, 1>;

struct SpectralEquations {
  EquationMatrix hessian = EquationMatrix::Zero();   // Jᵀ J
  EquationVector downhill = EquationVector::Zero();  // Jᵀ (measured − modelled)
  double cost = 0.0;                                 // Σ (measured − modelled)²
};

// Thread-safe: const after construction.
class SpectralMisfit {
 public:
  // wavelengthsNm: increasing, within the grid. edgeLossPerMm: that of the measurement
  // (core/skin/measurement_geometry.h); where there is one, the model is evaluated one set at a
  // time, which costs several times as much. The model outlives the misfit.
  SpectralMisfit(const SkinModel& model, std::span<const double> wavelengthsNm,
                 double edgeLossPerMm = 0.0);

  std::size_t wavelengthCount() const { return rows_.size(); }
  const ParameterAxes& axes() const { return axes_; }

  // One spectrum a column.
  Eigen::MatrixXd spectra(std::span<const ParameterVector> sets) const;

  // measured[i]: the spectrum that set i is compared with.
  std::vector<SpectralEquations> equations(std::span<const ParameterVector> sets,
                                           std::span<const double* const> measured) const;

 private:
  // [node][set]; derivatives by the absorptions of the layers, or none.
  struct NodeValues {
    std::vector<double> reflectance, perEpidermal, perDermal;
  };
  NodeValues evaluate(std::span<const ParameterVector> sets, bool derivatives) const;
  void evaluateSingly(std::span<const ParameterVector> sets, NodeValues& values) const;
  // A wavelength between two nodes, or at one (both the same).
  struct Row {
    std::size_t lower = 0;
    std::size_t upper = 0;
    double share = 0.0;  // of the upper
  };
  // Absorption per unit of each coordinate: of the epidermis, but for dermal haemoglobin.
  using NodeSlopes = std::array<double, kParameterCount>;

  const SkinModel& model_;
  MeasuredModel measured_;  // its edge loss alone
  ParameterAxes axes_;
  std::vector<Row> rows_;
  NodeModel nodes_;
  std::vector<NodeSlopes> slopes_;
};

}  // namespace cutis
