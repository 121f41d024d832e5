#pragma once  // internal to core/fit/spectra

// The model at measured wavelengths with constants of the profile as further coordinates, and the
// normal equations of its misfit: the inner part of core/fit/spectra/free_spectra_fit.cpp.
//
// A set is the five parameters and then the coordinates of the free constants
// (core/skin/free/free_coordinates.h). Derivatives are by the coordinates of
// core/fit/spectra/spectra_equations.h and these.

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/spectra/grid_interpolation.h"
#include "core/fit/spectra/spectra_search.h"
#include "core/maths/equation_sums.h"
#include "core/skin/free/free_skin.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/free_constants.h"

namespace cutis {

// N: 5 and the number of free constants. Thread-safe: const after construction.
template <int N>
class FreeMisfit final : public SpectraMisfit<N> {
 public:
  using Set = SearchPoint<N>;

  // wavelengthsNm: increasing, within the grid. edgeLossPerMm as in SpectralMisfit. Errors:
  // those of FreeSkin::make.
  static Result<FreeMisfit> make(const SkinModel& model, std::span<const double> wavelengthsNm,
                                 const FreeConstants& free, double edgeLossPerMm,
                                 const JobContext& context);

  std::size_t wavelengthCount() const override { return grid_.rows.size(); }
  const ParameterAxes& axes() const override { return skin_.axes(); }

  // These convert between a set and the constants it stands for; what is not free is the profile's.
  SkinConstants constantsAt(const Set& set) const;
  Set setAt(const ParameterVector& parameters, const SkinConstants& constants) const;

  Eigen::MatrixXd spectra(std::span<const Set> sets) const override;
  std::vector<EquationsOf<N>> equations(std::span<const Set> sets,
                                        std::span<const double* const> measured) const override;

 private:
  FreeMisfit(const SkinModel& model, GridInterpolation rows, FreeSkin skin);

  FreeSpectra evaluate(std::span<const Set> sets, bool derivatives) const;

  GridInterpolation grid_;
  FreeSkin skin_;
  std::vector<std::vector<double>> slopes_;  // per coordinate, at the samples
};

extern template class FreeMisfit<kParameterCount + 1>;
extern template class FreeMisfit<kParameterCount + 2>;

}  // namespace cutis
