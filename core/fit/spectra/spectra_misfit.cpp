#include "core/fit/spectra/spectra_misfit.h"

#include <array>
#include <cmath>

#include "core/skin/model/reflectance_batch.h"

namespace cutis {
std::array<double, kParameterCount> absorptionPerCoordinate(const SkinModel& model, int sample) {
  const ParameterAxes& axes = model.profile().axes;
  std::array<double, kParameterCount> slopes = {
      model.epidermis().eumelanin[sample], model.epidermis().pheomelanin[sample],
      model.dermis().blood[sample], model.epidermis().blood[sample],
      model.epidermis().carotene[sample]};
  for (std::size_t k = 0; k < slopes.size(); ++k)
    slopes[k] *= axes[k].maximum;
  slopes[1] *= axes[kMelanin].maximum / axes[kMelaninBlend].maximum;
  return slopes;
}

SpectraMisfit::SpectraMisfit(const SkinModel& model, std::span<const double> wavelengthsNm,
                             double edgeLossPerMm)
    : model_(model),
      instrument_(model, {0.0, 1.0, edgeLossPerMm}),
      axes_(model.profile().axes),
      grid_(gridInterpolation(wavelengthsNm)),
      compiled_(model, grid_.samples) {
  for (const int sample : grid_.samples)
    slopes_.push_back(absorptionPerCoordinate(model, sample));
}

SpectraMisfit::NodeValues SpectraMisfit::evaluate(std::span<const ParameterVector> sets,
                                                  bool derivatives) const {
  NodeValues values;
  const std::size_t size = slopes_.size() * sets.size();
  values.reflectance.resize(size);
  if (derivatives) {
    values.perEpidermal.resize(size);
    values.perDermal.resize(size);
  }
  if (instrument_.geometry().edgeLossPerMm > 0.0) {
    evaluateSingly(sets, values);
    return values;
  }
  const PixelBuffer<double> parameters = parameterRows<double>(sets);
  const auto atNodes = [&](std::vector<double>& of) {
    return packedRows(of.data(), slopes_.size(), sets.size());
  };
  if (derivatives) {
    reflectanceBatch<double>(compiled_, parameters.rows(), atNodes(values.reflectance),
                             atNodes(values.perEpidermal), atNodes(values.perDermal));
  } else {
    reflectanceBatch<double>(compiled_, parameters.rows(), atNodes(values.reflectance));
  }
  return values;
}

// Edge loss bends the dermis's absorption, which the vectorised model takes to be linear.
void SpectraMisfit::evaluateSingly(std::span<const ParameterVector> sets,
                                   NodeValues& values) const {
  for (std::size_t at = 0; at < values.reflectance.size(); ++at) {
    const int sample = compiled_.samples()[at / sets.size()];
    const ParameterVector& set = sets[at % sets.size()];
    const LayeredReflectance layered =
        instrument_.evaluate(sample, epidermalAbsorptionAt(model_.epidermis(), sample, set),
                             dermalAbsorptionAt(model_.dermis(), sample, set));
    values.reflectance[at] = layered.reflectance;
    if (values.perDermal.empty()) continue;
    values.perEpidermal[at] = layered.perEpidermalAbsorption;
    values.perDermal[at] = layered.perDermalAbsorption;
  }
}

Eigen::MatrixXd SpectraMisfit::spectra(std::span<const ParameterVector> sets) const {
  return interpolated(grid_, evaluate(sets, false).reflectance, sets.size());
}

std::vector<EquationsOf<kParameterCount>> SpectraMisfit::equations(
    std::span<const ParameterVector> sets, std::span<const double* const> measured) const {
  const std::size_t count = sets.size();
  const auto [reflectance, perEpidermal, perDermal] = evaluate(sets, true);

  EquationSums<kParameterCount> sums(count);
  for (std::size_t w = 0; w < grid_.rows.size(); ++w) {
    const InterpolatedRow& row = grid_.rows[w];
    const double above = row.share, below = 1.0 - row.share;
    const std::size_t lower = row.lower * count, upper = row.upper * count;
    double* residual = sums.residual();
    for (std::size_t i = 0; i < count; ++i) {
      residual[i] =
          measured[i][w] - (below * reflectance[lower + i] + above * reflectance[upper + i]);
    }
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      const double* per = (k == kHaemoglobinDermal ? perDermal : perEpidermal).data();
      const double ofLower = below * slopes_[row.lower][k], ofUpper = above * slopes_[row.upper][k];
      double* out = sums.gradient(k);
      for (std::size_t i = 0; i < count; ++i) {
        out[i] = ofLower * per[lower + i] + ofUpper * per[upper + i];
      }
    }
    sums.add();
  }
  return sums.equations();
}

}  // namespace cutis
