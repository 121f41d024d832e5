#pragma once  // internal to core/fit/spectra

// The model at measured wavelengths for many parameter sets at once, and the normal equations of
// their misfit: the inner part of core/fit/spectra/spectra_fit.cpp.
//
// In absorptions the model is close to linear, so derivatives are with respect to what absorbs: the
// amounts of eumelanin C_m β_m and pheomelanin C_m (1 − β_m), then of the other chromophores, each
// in units of its range (both melanins in units of that of C_m). The amounts of further
// chromophores are such coordinates already, from 0 to 1.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/fit/spectra/grid_interpolation.h"
#include "core/fit/spectra/spectra_search.h"
#include "core/maths/equation_sums.h"
#include "core/skin/model/compiled_model.h"
#include "core/skin/model/instrument_model.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

// Absorption at a sample of the grid per unit of each coordinate above, in the layer of its
// chromophore; one for each parameter of the profile.
std::vector<double> absorptionPerCoordinate(const SkinModel& model, int sample);

// N: the number of the profile's parameters. Thread-safe: const after construction.
template <int N>
class SpectralMisfit final : public SpectraMisfit<N> {
 public:
  using Point = SearchPoint<N>;

  // wavelengthsNm: increasing, within the grid. edgeLossPerMm: that of the measurement
  // (core/skin/model/measurement_geometry.h); where there is one, or a further chromophore, the
  // model is evaluated one set at a time, which costs several times as much. The model outlives the
  // misfit.
  SpectralMisfit(const SkinModel& model, std::span<const double> wavelengthsNm,
                 double edgeLossPerMm = 0.0);

  std::size_t wavelengthCount() const override { return grid_.rows.size(); }
  const ParameterAxes& axes() const override { return model_.profile().axes; }
  // In their units.
  std::array<double, N> parametersAt(const Point& point) const;

  Eigen::MatrixXd spectra(std::span<const Point> points) const override;
  std::vector<EquationsOf<N>> equations(std::span<const Point> points,
                                        std::span<const double* const> measured) const override;

 private:
  // [sample][point]; derivatives by the absorptions of the layers, or none.
  struct SampleValues {
    std::vector<double> reflectance, perEpidermal, perDermal;
  };
  SampleValues evaluate(std::span<const Point> points, bool derivatives) const;
  void evaluateSingly(std::span<const Point> points, SampleValues& values) const;

  const SkinModel& model_;
  InstrumentModel instrument_;  // its edge loss alone
  GridInterpolation grid_;
  std::optional<CompiledModel> compiled_;    // at the samples of the rows
  std::vector<std::vector<double>> slopes_;  // per coordinate, at the samples
};

extern template class SpectralMisfit<kParameterCount>;
extern template class SpectralMisfit<kParameterCount + 1>;
extern template class SpectralMisfit<kParameterCount + 2>;

}  // namespace cutis
