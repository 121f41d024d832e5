#include "core/fit/refined/refined_problem.h"

#include <cstddef>

#include "core/fit/coordinate_prior.h"

namespace cutis {
namespace {

constexpr int kProblemRounds = 100;

}  // namespace

template <typename T>
RefinedProblemData<T>::RefinedProblemData(const SkinModel& model, const SpectralNodes& nodes,
                                          const Prior& prior, const NoiseModel& noise,
                                          const FitOptions& options,
                                          const ChannelDiscrepancy& discrepancy)
    : model_(model, nodes.samples) {
  const Eigen::Index channels =
      discrepancy.empty() ? nodes.weights.rows() : discrepancy.offset.size();
  for (Eigen::Index k = 0; k < channels; ++k) {
    for (Eigen::Index n = 0; n < nodes.weights.cols(); ++n) {
      weights_.push_back(static_cast<T>(nodes.weights(k, n)));
    }
  }
  problem_.nodes = model_.template nodes<T>().data();
  problem_.nodeCount = model_.template nodes<T>().size();
  problem_.layers = model_.template layers<T>();
  problem_.weights = weights_.data();
  problem_.channelCount = static_cast<std::size_t>(channels);
  problem_.readVariance = static_cast<T>(noise.read * noise.read);
  problem_.proportionalVariance = static_cast<T>(noise.proportional * noise.proportional);
  problem_.veil = static_cast<T>(noise.veil);
  problem_.maximumRounds = kProblemRounds;
  if (options.shading) {
    problem_.shadingPrecision = static_cast<T>(1.0 / (*options.shading * *options.shading));
  }
  setCoordinates(model.profile().axes, prior, options);
  setCurvature(model);
  if (!discrepancy.empty()) setDiscrepancy(discrepancy);
}

template <typename T>
void RefinedProblemData<T>::setDiscrepancy(const ChannelDiscrepancy& discrepancy) {
  problem_.hasDiscrepancy = true;
  std::size_t next = 0;
  for (Eigen::Index k = 0; k < discrepancy.offset.size(); ++k) {
    problem_.channelOffset[k] = static_cast<T>(discrepancy.offset[k]);
    for (int i = 0; i < kParameterCount; ++i)
      problem_.channelSlope[k][i] = static_cast<T>(discrepancy.slope(k, i));
    for (Eigen::Index j = 0; j <= k; ++j)
      problem_.channelCovariance[next++] = static_cast<T>(discrepancy.covariance(k, j));
  }
  problem_.coefficientCount = static_cast<std::size_t>(discrepancy.count());
  for (int c = 0; c < discrepancy.count(); ++c) {
    problem_.coefficientOffset[c] = static_cast<T>(discrepancy.coefficientOffset[c]);
    for (int i = 0; i < kParameterCount; ++i)
      problem_.coefficientSlope[c][i] = static_cast<T>(discrepancy.coefficientSlope(c, i));
    for (Eigen::Index k = 0; k < discrepancy.gain.cols(); ++k)
      problem_.coefficientGain[c][k] = static_cast<T>(discrepancy.gain(c, k));
  }
}

template <typename T>
void RefinedProblemData<T>::setCoordinates(const ParameterAxes& axes, const Prior& prior,
                                           const FitOptions& options) {
  const CoordinatePrior coordinates = coordinatePrior(prior, axes, options.fixed);
  for (int i = 0; i < kParameterCount; ++i) {
    const auto index = static_cast<std::size_t>(i);
    problem_.isLog[i] = coordinates.isLog[index];
    problem_.isFixed[i] = coordinates.isFixed[index];
    problem_.low[i] = static_cast<T>(coordinates.low[i]);
    problem_.high[i] = static_cast<T>(coordinates.high[i]);
    problem_.priorMean[i] = static_cast<T>(coordinates.mean[i]);
    problem_.priorDeviation[i] = static_cast<T>(coordinates.deviation[i]);
    for (int j = 0; j < kParameterCount; ++j) {
      problem_.priorPrecision[i][j] = static_cast<T>(coordinates.precision(i, j));
    }
  }
}

template <typename T>
void RefinedProblemData<T>::setCurvature(const SkinModel& model) {
  constexpr int green = (550 - kFirstWavelengthNm) / kWavelengthStepNm;
  const AbsorptionLaw& law = model.absorption();
  for (const Parameter darkest : {kMelanin, kHaemoglobinDermal}) {
    problem_.rootOffset[darkest] =
        static_cast<T>(law.base(law.layerOf(darkest), green) / law.perUnit(darkest, green));
  }
}

template class RefinedProblemData<float>;
template class RefinedProblemData<double>;

}  // namespace cutis
