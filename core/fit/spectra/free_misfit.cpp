#include "core/fit/spectra/free_misfit.h"

#include <cassert>
#include <utility>

#include "core/fit/spectra/spectra_equations.h"

namespace cutis {

template <int N>
Result<FreeMisfit<N>> FreeMisfit<N>::make(const SkinModel& model,
                                          std::span<const double> wavelengthsNm,
                                          const FreeConstants& free, double edgeLossPerMm,
                                          const JobContext& context) {
  assert(free.count() == N - kParameterCount);
  GridInterpolation rows = gridInterpolation(wavelengthsNm);
  CUTIS_TRY(skin, FreeSkin::make(model, rows.samples, free, context, {edgeLossPerMm}));
  return FreeMisfit(model, std::move(rows), std::move(skin));
}

template <int N>
FreeMisfit<N>::FreeMisfit(const SkinModel& model, GridInterpolation rows, FreeSkin skin)
    : grid_(std::move(rows)), skin_(std::move(skin)) {
  for (const int sample : grid_.samples)
    slopes_.push_back(absorptionPerCoordinate(model, sample));
}

template <int N>
SkinConstants FreeMisfit<N>::constantsAt(const Set& set) const {
  return skin_.coordinates().constantsAt(set.data() + kParameterCount);
}

template <int N>
auto FreeMisfit<N>::setAt(const ParameterVector& parameters, const SkinConstants& constants) const
    -> Set {
  Set set;
  set.template head<kParameterCount>() = parameters;
  skin_.coordinates().coordinatesOf(constants, set.data() + kParameterCount);
  return set;
}

template <int N>
FreeSpectra FreeMisfit<N>::evaluate(std::span<const Set> sets, bool derivatives) const {
  std::vector<ParameterVector> parameters;
  std::vector<SkinConstants> constants;
  for (const Set& set : sets) {
    parameters.emplace_back(set.template head<kParameterCount>());
    constants.push_back(constantsAt(set));
  }
  return skin_.evaluate(parameters, constants, derivatives);
}

template <int N>
Eigen::MatrixXd FreeMisfit<N>::spectra(std::span<const Set> sets) const {
  return interpolated(grid_.rows, evaluate(sets, false).reflectance, sets.size());
}

template <int N>
std::vector<EquationsOf<N>> FreeMisfit<N>::equations(
    std::span<const Set> sets, std::span<const double* const> measured) const {
  const std::size_t count = sets.size();
  const FreeSpectra spectra = evaluate(sets, true);
  const FreeCoordinates& coordinates = skin_.coordinates();
  const int oxygenationAt = coordinates.indexOf(kOxygenation),
            thicknessAt = coordinates.indexOf(kThickness);
  std::vector<double> thicknessSlopes;
  for (const Set& set : sets)
    thicknessSlopes.push_back(coordinates.slope(kThickness, constantsAt(set)));
  // ∂R by coordinate k of set i at a sample.
  const auto slope = [&](std::size_t s, std::size_t i, int k) {
    const std::size_t at = s * count + i;
    if (k >= kParameterCount && k - kParameterCount == thicknessAt) {
      return spectra.perThickness[at] * thicknessSlopes[i];
    }
    if (k >= kParameterCount && k - kParameterCount == oxygenationAt) {
      return spectra.perOxygenation[at];
    }
    // The blood of a skin has an absorption of its own.
    if (k == kHaemoglobinDermal) {
      return spectra.perDermal[at] * spectra.dermalBlood[at] * axes()[kHaemoglobinDermal].maximum;
    }
    if (k == kHaemoglobinEpidermal) {
      return spectra.perEpidermal[at] * spectra.epidermalBlood[at] *
             axes()[kHaemoglobinEpidermal].maximum;
    }
    const bool inDermis = skin_.absorption().layerOf(k) == SkinLayer::dermis;
    return (inDermis ? spectra.perDermal[at] : spectra.perEpidermal[at]) *
           slopes_[s][static_cast<std::size_t>(k)];
  };
  EquationSums<N> sums(count);
  for (std::size_t w = 0; w < grid_.rows.size(); ++w) {
    const InterpolatedRow& row = grid_.rows[w];
    const double above = row.share, below = 1.0 - row.share;
    for (std::size_t i = 0; i < count; ++i) {
      sums.residual()[i] = measured[i][w] - (below * spectra.reflectance[row.lower * count + i] +
                                             above * spectra.reflectance[row.upper * count + i]);
      for (int k = 0; k < N; ++k) {
        sums.gradient(static_cast<std::size_t>(k))[i] =
            below * slope(row.lower, i, k) + above * slope(row.upper, i, k);
      }
    }
    sums.add();
  }
  return sums.equations();
}

template class FreeMisfit<kParameterCount + 1>;
template class FreeMisfit<kParameterCount + 2>;

}  // namespace cutis
