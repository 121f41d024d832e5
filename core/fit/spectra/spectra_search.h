#pragma once  // internal to core/fit/spectra

// Bounded least squares over the parameters of a spectrum, for five of them or with up to two
// further coordinates: the inner part of core/fit/spectra/spectra_fit.cpp and
// core/fit/spectra/free_spectra_fit.cpp.
//
// A point is the five parameters and then further coordinates from 0 to 1. N, of points and
// misfits: 5 to 7.

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/maths/equation_sums.h"
#include "core/skin/profile/parameter_axis.h"

namespace cutis {

template <int N>
using SearchPoint = Eigen::Array<double, N, 1>;

// What is searched for its lowest point. Thread-safe: const after construction.
template <int N>
class SpectraMisfit {
 public:
  virtual ~SpectraMisfit() = default;

  virtual std::size_t wavelengthCount() const = 0;
  // One for each of the five parameters.
  virtual const ParameterAxes& axes() const = 0;
  // One spectrum a column.
  virtual Eigen::MatrixXd spectra(std::span<const SearchPoint<N>> points) const = 0;
  // measured[i]: the spectrum that point i is compared with. Derivatives are by the coordinates of
  // core/fit/spectra/spectra_equations.h, then by the further ones.
  virtual std::vector<EquationsOf<N>> equations(std::span<const SearchPoint<N>> points,
                                                std::span<const double* const> measured) const = 0;
};

// Points all over the box to begin among.
template <int N>
std::vector<SearchPoint<N>> searchSamples(const ParameterAxes& axes);

template <int N>
struct FoundPoint {
  SearchPoint<N> point = SearchPoint<N>::Zero();
  double rmse = 0.0;
};

// The best of searches from the nearest of `samples` and, where there are `known` points, one a
// spectrum, from these. reflectances: [spectrum][wavelength]. Fails only when cancelled.
template <int N>
Result<std::vector<FoundPoint<N>>> searchSpectra(const SpectraMisfit<N>& misfit,
                                                 std::vector<SearchPoint<N>> samples,
                                                 std::span<const SearchPoint<N>> known,
                                                 std::span<const double> reflectances,
                                                 const JobContext& context);

}  // namespace cutis
