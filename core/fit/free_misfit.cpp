#include "core/fit/free_misfit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/fit/spectra_equations.h"
#include "core/skin/absorption.h"

namespace cutis {

template <int N>
Result<FreeMisfit<N>> FreeMisfit<N>::make(const SkinModel& model,
                                          std::span<const double> wavelengthsNm,
                                          const FreeConstants& free, double edgeLossPerMm,
                                          const JobContext& context) {
  assert(free.count() == N - kParameterCount);
  MeasuredRows rows = measuredRows(wavelengthsNm);
  CUTIS_TRY(layers, VariableLayers::make(model.profile(), rows.samples, free, context));
  FreeMisfit misfit(model, std::move(rows), free, std::move(layers), edgeLossPerMm);
  if (free.thickness) {
    CUTIS_TRY(range, thicknessRange(model.profile()));
    misfit.thickness_ = range;
    misfit.logThicknessRange_ = std::log(range.highMm / range.lowMm);
  }
  return misfit;
}

template <int N>
FreeMisfit<N>::FreeMisfit(const SkinModel& model, MeasuredRows rows, const FreeConstants& free,
                          VariableLayers layers, double edgeLossPerMm)
    : model_(&model),
      rows_(std::move(rows)),
      oxygenationAt_(free.oxygenation ? kParameterCount : -1),
      thicknessAt_(free.thickness ? N - 1 : -1),
      edge_{0.0, 1.0, edgeLossPerMm},
      blood_(model.profile(), rows_.samples, free.oxygenation),
      layers_(std::move(layers)) {
  const Spectrum scattering = dermalScattering(model.profile());
  for (const int sample : rows_.samples) {
    dermalScattering_.push_back(scattering[sample]);
    slopes_.push_back(absorptionPerCoordinate(model, sample));
  }
}

template <int N>
SkinConstants FreeMisfit<N>::constantsAt(const Set& set) const {
  SkinConstants constants = constantsOf(model_->profile());
  if (oxygenationAt_ >= 0) constants.oxygenation = set[oxygenationAt_];
  if (thicknessAt_ >= 0) {
    const double thickness = thickness_.lowMm * std::exp(logThicknessRange_ * set[thicknessAt_]);
    constants.thicknessMm = std::clamp(thickness, thickness_.lowMm, thickness_.highMm);
  }
  return constants;
}

template <int N>
auto FreeMisfit<N>::setAt(const ParameterVector& parameters, const SkinConstants& constants) const
    -> Set {
  Set set;
  set.template head<kParameterCount>() = parameters;
  if (oxygenationAt_ >= 0) set[oxygenationAt_] = constants.oxygenation;
  if (thicknessAt_ >= 0) {
    set[thicknessAt_] = std::clamp(
        std::log(constants.thicknessMm / thickness_.lowMm) / logThicknessRange_, 0.0, 1.0);
  }
  return set;
}

template <int N>
auto FreeMisfit<N>::statesOf(std::span<const Set> sets) const -> States {
  const std::size_t count = sets.size(), sampleCount = rows_.samples.size();
  States states;
  std::vector<double> oxygenations;
  for (const Set& set : sets) {
    const SkinConstants constants = constantsAt(set);
    oxygenations.push_back(constants.oxygenation);
    states.thicknessMm.push_back(constants.thicknessMm);
  }
  states.blood = blood_.at(oxygenations);
  const EpidermalAbsorption& epidermis = model_->epidermis();
  const DermalAbsorption& dermis = model_->dermis();
  for (std::size_t s = 0; s < sampleCount; ++s) {
    const int sample = rows_.samples[s];
    for (std::size_t i = 0; i < count; ++i) {
      ParameterVector bloodless = sets[i].template head<kParameterCount>();
      const double inEpidermis = bloodless[kHaemoglobinEpidermal];
      bloodless[kHaemoglobinEpidermal] = 0.0;
      const std::size_t at = s * count + i;
      states.epidermal.push_back(epidermalAbsorptionAt(epidermis, sample, bloodless) +
                                 inEpidermis * states.blood.epidermal[at]);
      const double dermal = dermis.base[sample] +
                            sets[i][kHaemoglobinDermal] * states.blood.dermal[at];
      const EffectiveAbsorption effective = withEdgeLoss(edge_, dermal, dermalScattering_[s]);
      states.dermal.push_back(effective.absorption);
      states.edgeSlope.push_back(effective.slope);
    }
  }
  return states;
}

template <int N>
Eigen::MatrixXd FreeMisfit<N>::spectra(std::span<const Set> sets) const {
  const std::size_t count = sets.size();
  const States states = statesOf(sets);
  const LayerSpectra layers =
      layers_.evaluate({states.thicknessMm.data(), states.epidermal.data(), states.dermal.data(),
                        count},
                       false);
  Eigen::MatrixXd spectra(rows_.rows.size(), count);
  for (std::size_t w = 0; w < rows_.rows.size(); ++w) {
    const MeasuredRow& row = rows_.rows[w];
    for (std::size_t i = 0; i < count; ++i) {
      spectra(static_cast<Eigen::Index>(w), static_cast<Eigen::Index>(i)) =
          (1.0 - row.share) * layers.reflectance[row.lower * count + i] +
          row.share * layers.reflectance[row.upper * count + i];
    }
  }
  return spectra;
}

template <int N>
std::vector<EquationsOf<N>> FreeMisfit<N>::equations(
    std::span<const Set> sets, std::span<const double* const> measured) const {
  const std::size_t count = sets.size();
  const States states = statesOf(sets);
  const LayerSpectra layers =
      layers_.evaluate({states.thicknessMm.data(), states.epidermal.data(), states.dermal.data(),
                        count},
                       true);
  const ParameterAxes& axes = model_->profile().axes;
  // ∂R by coordinate k of set i at a sample.
  const auto slope = [&](std::size_t s, std::size_t i, int k) {
    const std::size_t at = s * count + i;
    const double perEpidermal = layers.perEpidermalAbsorption[at];
    const double perDermal = layers.perDermalAbsorption[at] * states.edgeSlope[at];
    if (k == thicknessAt_) {
      return layers.perThickness[at] * states.thicknessMm[i] * logThicknessRange_;
    }
    if (k == oxygenationAt_) {
      return perDermal * sets[i][kHaemoglobinDermal] * states.blood.dermalSlope[at] +
             perEpidermal * sets[i][kHaemoglobinEpidermal] * states.blood.epidermalSlope[at];
    }
    if (k == kHaemoglobinDermal) {
      return perDermal * states.blood.dermal[at] * axes[kHaemoglobinDermal].maximum;
    }
    if (k == kHaemoglobinEpidermal) {
      return perEpidermal * states.blood.epidermal[at] * axes[kHaemoglobinEpidermal].maximum;
    }
    return perEpidermal * slopes_[s][static_cast<std::size_t>(k)];
  };
  EquationSums<N> sums(count);
  for (std::size_t w = 0; w < rows_.rows.size(); ++w) {
    const MeasuredRow& row = rows_.rows[w];
    const double above = row.share, below = 1.0 - row.share;
    for (std::size_t i = 0; i < count; ++i) {
      sums.residual()[i] = measured[i][w] - (below * layers.reflectance[row.lower * count + i] +
                                             above * layers.reflectance[row.upper * count + i]);
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
