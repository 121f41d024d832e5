#include "core/fit/spectra_equations.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/skin/reflectance_batch.h"

namespace cutis {
namespace {

// Of the lower triangle of the hessian, the slopes and the cost.
constexpr std::size_t kHessianSums = kParameterCount * (kParameterCount + 1) / 2;
constexpr std::size_t kSums = kHessianSums + kParameterCount + 1;

// The last grid sample that is not above a wavelength, and how far it is on the way to the next.
int sampleBelow(double wavelengthNm) {
  const double position = (wavelengthNm - kFirstWavelengthNm) / kWavelengthStepNm;
  return std::clamp(static_cast<int>(std::floor(position)), 0, kSampleCount - 1);
}

double shareAbove(double wavelengthNm) {
  const double position = (wavelengthNm - kFirstWavelengthNm) / kWavelengthStepNm;
  return position - sampleBelow(wavelengthNm);
}

std::vector<int> samplesNeeded(std::span<const double> wavelengthsNm) {
  std::vector<int> samples;
  for (const double wavelength : wavelengthsNm) {
    samples.push_back(sampleBelow(wavelength));
    if (shareAbove(wavelength) > 0.0) samples.push_back(samples.back() + 1);
  }
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  return samples;
}

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

SpectralMisfit::SpectralMisfit(const SkinModel& model, std::span<const double> wavelengthsNm,
                               double edgeLossPerMm)
    : model_(model),
      measured_(model, {0.0, 1.0, edgeLossPerMm}),
      axes_(model.profile().axes),
      nodes_(model, samplesNeeded(wavelengthsNm)) {
  const std::vector<int>& samples = nodes_.samples();
  for (const double wavelength : wavelengthsNm) {
    Row row;
    const auto at = std::lower_bound(samples.begin(), samples.end(), sampleBelow(wavelength));
    row.lower = static_cast<std::size_t>(at - samples.begin());
    row.share = shareAbove(wavelength);
    row.upper = row.share > 0.0 ? row.lower + 1 : row.lower;
    rows_.push_back(row);
  }
  for (const int sample : samples) {
    NodeSlopes slopes = {model.epidermis().eumelanin[sample], model.epidermis().pheomelanin[sample],
                         model.dermis().blood[sample], model.epidermis().blood[sample],
                         model.epidermis().carotene[sample]};
    for (std::size_t k = 0; k < slopes.size(); ++k)
      slopes[k] *= axes_[k].maximum;
    slopes[1] *= axes_[kMelanin].maximum / axes_[kMelaninBlend].maximum;
    slopes_.push_back(slopes);
  }
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
  Eigen::MatrixXd spectra(rows_.size(), count);
  for (std::size_t w = 0; w < rows_.size(); ++w) {
    const Row& row = rows_[w];
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

  // [sum][set]: the loops over sets run in vectors.
  std::vector<double> sums(kSums * count);
  std::vector<double> gradient(kParameterCount * count), residual(count);
  for (std::size_t w = 0; w < rows_.size(); ++w) {
    const Row& row = rows_[w];
    const double above = row.share, below = 1.0 - row.share;
    const std::size_t lower = row.lower * count, upper = row.upper * count;
    for (std::size_t i = 0; i < count; ++i) {
      residual[i] =
          measured[i][w] - (below * reflectance[lower + i] + above * reflectance[upper + i]);
    }
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      const double* per = (k == kHaemoglobinDermal ? perDermal : perEpidermal).data();
      const double ofLower = below * slopes_[row.lower][k], ofUpper = above * slopes_[row.upper][k];
      double* out = gradient.data() + k * count;
      for (std::size_t i = 0; i < count; ++i) {
        out[i] = ofLower * per[lower + i] + ofUpper * per[upper + i];
      }
    }
    double* sum = sums.data();
    const auto addProducts = [&](const double* a, const double* b) {
      for (std::size_t i = 0; i < count; ++i)
        sum[i] += a[i] * b[i];
      sum += count;
    };
    for (std::size_t j = 0; j < kParameterCount; ++j) {
      for (std::size_t k = 0; k <= j; ++k) {
        addProducts(gradient.data() + j * count, gradient.data() + k * count);
      }
    }
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      addProducts(gradient.data() + k * count, residual.data());
    }
    addProducts(residual.data(), residual.data());
  }

  std::vector<SpectralEquations> equations(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* sum = sums.data() + i;
    const auto next = [&] {
      const double value = *sum;
      sum += count;
      return value;
    };
    SpectralEquations& own = equations[i];
    for (int j = 0; j < kParameterCount; ++j) {
      for (int k = 0; k <= j; ++k)
        own.hessian(j, k) = own.hessian(k, j) = next();
    }
    for (int k = 0; k < kParameterCount; ++k)
      own.downhill[k] = next();
    own.cost = next();
  }
  return equations;
}

}  // namespace cutis
