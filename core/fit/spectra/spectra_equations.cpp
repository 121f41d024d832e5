#include "core/fit/spectra/spectra_equations.h"

#include <cassert>

#include "core/skin/model/reflectance_batch.h"

namespace cutis {
std::vector<double> absorptionPerCoordinate(const SkinModel& model, int sample) {
  const Profile& profile = model.profile();
  std::vector<double> slopes;
  for (int k = 0; k < parameterCount(profile); ++k)
    slopes.push_back(model.absorption().perUnit(k, sample) * axisOf(profile, k).maximum);
  // The amount of pheomelanin has the range of melanin.
  slopes[kMelaninBlend] *= profile.axes[kMelanin].maximum / profile.axes[kMelaninBlend].maximum;
  return slopes;
}

template <int N>
SpectralMisfit<N>::SpectralMisfit(const SkinModel& model, std::span<const double> wavelengthsNm,
                                  double edgeLossPerMm)
    : model_(model),
      instrument_(model, {0.0, 1.0, edgeLossPerMm}),
      grid_(gridInterpolation(wavelengthsNm)) {
  assert(parameterCount(model.profile()) == N);
  if (N == kParameterCount && edgeLossPerMm == 0.0) compiled_.emplace(model, grid_.samples);
  for (const int sample : grid_.samples)
    slopes_.push_back(absorptionPerCoordinate(model, sample));
}

template <int N>
std::array<double, N> SpectralMisfit<N>::parametersAt(const Point& point) const {
  std::array<double, N> parameters;
  for (int k = 0; k < N; ++k) {
    const double unit = k < kParameterCount ? 1.0 : axisOf(model_.profile(), k).maximum;
    parameters[static_cast<std::size_t>(k)] = unit * point[k];
  }
  return parameters;
}

template <int N>
auto SpectralMisfit<N>::evaluate(std::span<const Point> points, bool derivatives) const
    -> SampleValues {
  SampleValues values;
  const std::size_t size = slopes_.size() * points.size();
  values.reflectance.resize(size);
  if (derivatives) {
    values.perEpidermal.resize(size);
    values.perDermal.resize(size);
  }
  if constexpr (N == kParameterCount) {
    if (compiled_) {
      const PixelBuffer<double> parameters = parameterRows<double>(points);
      const auto atSamples = [&](std::vector<double>& of) {
        return packedRows(of.data(), slopes_.size(), points.size());
      };
      if (derivatives) {
        reflectanceBatch<double>(*compiled_, parameters.rows(), atSamples(values.reflectance),
                                 atSamples(values.perEpidermal), atSamples(values.perDermal));
      } else {
        reflectanceBatch<double>(*compiled_, parameters.rows(), atSamples(values.reflectance));
      }
      return values;
    }
  }
  evaluateSingly(points, values);
  return values;
}

// Edge loss bends the dermis's absorption, which the vectorised model takes to be linear; and that
// model knows five parameters alone.
template <int N>
void SpectralMisfit<N>::evaluateSingly(std::span<const Point> points, SampleValues& values) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<double, N> parameters = parametersAt(points[i]);
    for (std::size_t s = 0; s < slopes_.size(); ++s) {
      const int sample = grid_.samples[s];
      const LayerPair absorption = model_.absorption().at(sample, parameters);
      const LayeredReflectance layered =
          instrument_.evaluate(sample, absorption.epidermal, absorption.dermal);
      const std::size_t at = s * points.size() + i;
      values.reflectance[at] = layered.reflectance;
      if (values.perDermal.empty()) continue;
      values.perEpidermal[at] = layered.perEpidermalAbsorption;
      values.perDermal[at] = layered.perDermalAbsorption;
    }
  }
}

template <int N>
Eigen::MatrixXd SpectralMisfit<N>::spectra(std::span<const Point> points) const {
  return interpolated(grid_.rows, evaluate(points, false).reflectance, points.size());
}

template <int N>
std::vector<EquationsOf<N>> SpectralMisfit<N>::equations(
    std::span<const Point> points, std::span<const double* const> measured) const {
  const std::size_t count = points.size();
  const auto [reflectance, perEpidermal, perDermal] = evaluate(points, true);

  EquationSums<N> sums(count);
  for (std::size_t w = 0; w < grid_.rows.size(); ++w) {
    const InterpolatedRow& row = grid_.rows[w];
    const double above = row.share, below = 1.0 - row.share;
    const std::size_t lower = row.lower * count, upper = row.upper * count;
    double* residual = sums.residual();
    for (std::size_t i = 0; i < count; ++i) {
      residual[i] =
          measured[i][w] - (below * reflectance[lower + i] + above * reflectance[upper + i]);
    }
    for (std::size_t k = 0; k < N; ++k) {
      const bool inDermis = model_.absorption().layerOf(static_cast<int>(k)) == SkinLayer::dermis;
      const double* per = (inDermis ? perDermal : perEpidermal).data();
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

template class SpectralMisfit<kParameterCount>;
template class SpectralMisfit<kParameterCount + 1>;
template class SpectralMisfit<kParameterCount + 2>;

}  // namespace cutis
