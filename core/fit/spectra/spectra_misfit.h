#pragma once

// The model at measured wavelengths for many parameter sets at once, and the normal equations of
// their misfit: the inner part of core/fit/spectra/spectra_fit.cpp.
//
// In absorptions the model is close to linear, so derivatives are with respect to what absorbs: the
// amounts of eumelanin C_m β_m and pheomelanin C_m (1 − β_m), then dermal and epidermal haemoglobin
// and carotene, each in units of its range (both melanins in units of that of C_m).

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/fit/spectra/grid_interpolation.h"
#include "core/maths/equation_sums.h"
#include "core/skin/model/compiled_model.h"
#include "core/skin/model/instrument_model.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

// Absorption at a sample of the grid per unit of each coordinate above: of the epidermis, but for
// dermal haemoglobin.
std::array<double, kParameterCount> absorptionPerCoordinate(const SkinModel& model, int sample);

// Thread-safe: const after construction.
class SpectraMisfit {
 public:
  // wavelengthsNm: increasing, within the grid. edgeLossPerMm: that of the measurement
  // (core/skin/model/measurement_geometry.h); where there is one, the model is evaluated one set at
  // a time, which costs several times as much. The model outlives the misfit.
  SpectraMisfit(const SkinModel& model, std::span<const double> wavelengthsNm,
                double edgeLossPerMm = 0.0);

  static constexpr int kCoordinates = kParameterCount;

  std::size_t wavelengthCount() const { return grid_.rows.size(); }
  const ParameterAxes& axes() const { return axes_; }

  // One spectrum a column.
  Eigen::MatrixXd spectra(std::span<const ParameterVector> sets) const;

  // measured[i]: the spectrum that set i is compared with.
  std::vector<EquationsOf<kParameterCount>> equations(
      std::span<const ParameterVector> sets, std::span<const double* const> measured) const;

 private:
  // [node][set]; derivatives by the absorptions of the layers, or none.
  struct NodeValues {
    std::vector<double> reflectance, perEpidermal, perDermal;
  };
  NodeValues evaluate(std::span<const ParameterVector> sets, bool derivatives) const;
  void evaluateSingly(std::span<const ParameterVector> sets, NodeValues& values) const;

  const SkinModel& model_;
  InstrumentModel instrument_;  // its edge loss alone
  ParameterAxes axes_;
  GridInterpolation grid_;
  CompiledModel compiled_;
  std::vector<std::array<double, kParameterCount>> slopes_;  // per coordinate, at the nodes
};

}  // namespace cutis
