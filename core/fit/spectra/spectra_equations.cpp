#include "core/fit/spectra/spectra_equations.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/skin/model/reflectance_batch.h"

namespace cutis {
namespace {

struct ParameterColumns {
  explicit ParameterColumns(std::span<const ParameterVector> sets)
      : values(sets.size() * kParameterCount) {
    batch.count = sets.size();
    for (std::size_t k = 0; k < batch.values.size(); ++k) {
      double* column = values.data() + k * sets.size();
      batch.values[k] = column;
      for (std::size_t i = 0; i < sets.size(); ++i) {
        column[i] = sets[i][static_cast<Eigen::Index>(k)];
      }
    }
  }

  std::vector<double> values;
  ParameterBatch<double> batch = {};
};

}  // namespace

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

SpectralMisfit::SpectralMisfit(const SkinModel& model, std::span<const double> wavelengthsNm,
                               double edgeLossPerMm)
    : model_(model),
      measured_(model, {0.0, 1.0, edgeLossPerMm}),
      axes_(model.profile().axes),
      measuredRows_(measuredRows(wavelengthsNm)),
      nodes_(model, measuredRows_.samples) {
  for (const int sample : measuredRows_.samples)
    slopes_.push_back(absorptionPerCoordinate(model, sample));
}

SpectralMisfit::NodeValues SpectralMisfit::evaluate(std::span<const ParameterVector> sets,
                                                    bool derivatives) const {
  NodeValues values;
  const std::size_t size = slopes_.size() * sets.size();
  values.reflectance.resize(size);
  if (derivatives) {
    values.perEpidermal.resize(size);
    values.perDermal.resize(size);
  }
  if (measured_.geometry().edgeLossPerMm > 0.0) {
    evaluateSingly(sets, values);
    return values;
  }
  const ParameterColumns columns(sets);
  if (derivatives) {
    reflectanceBatch<double>(nodes_, columns.batch, values.reflectance.data(),
                             values.perEpidermal.data(), values.perDermal.data());
  } else {
    reflectanceBatch<double>(nodes_, columns.batch, values.reflectance.data());
  }
  return values;
}

// Edge loss bends the dermis's absorption, which the vectorised model takes to be linear.
void SpectralMisfit::evaluateSingly(std::span<const ParameterVector> sets,
                                    NodeValues& values) const {
  for (std::size_t at = 0; at < values.reflectance.size(); ++at) {
    const int sample = nodes_.samples()[at / sets.size()];
    const ParameterVector& set = sets[at % sets.size()];
    const LayeredReflectance layered =
        measured_.evaluate(sample, epidermalAbsorptionAt(model_.epidermis(), sample, set),
                           dermalAbsorptionAt(model_.dermis(), sample, set));
    values.reflectance[at] = layered.reflectance;
    if (values.perDermal.empty()) continue;
    values.perEpidermal[at] = layered.perEpidermalAbsorption;
    values.perDermal[at] = layered.perDermalAbsorption;
  }
}

Eigen::MatrixXd SpectralMisfit::spectra(std::span<const ParameterVector> sets) const {
  const std::size_t count = sets.size();
  const std::vector<double> reflectance = evaluate(sets, false).reflectance;
  const std::vector<MeasuredRow>& rows = measuredRows_.rows;
  Eigen::MatrixXd spectra(rows.size(), count);
  for (std::size_t w = 0; w < rows.size(); ++w) {
    const MeasuredRow& row = rows[w];
    for (std::size_t i = 0; i < count; ++i) {
      spectra(static_cast<Eigen::Index>(w), static_cast<Eigen::Index>(i)) =
          (1.0 - row.share) * reflectance[row.lower * count + i] +
          row.share * reflectance[row.upper * count + i];
    }
  }
  return spectra;
}

std::vector<SpectralEquations> SpectralMisfit::equations(
    std::span<const ParameterVector> sets, std::span<const double* const> measured) const {
  const std::size_t count = sets.size();
  const auto [reflectance, perEpidermal, perDermal] = evaluate(sets, true);

  EquationSums<kParameterCount> sums(count);
  for (std::size_t w = 0; w < measuredRows_.rows.size(); ++w) {
    const MeasuredRow& row = measuredRows_.rows[w];
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
