#include "core/fit/refined/exact_pass.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace cutis {
namespace {

constexpr double kExactPassTolerance = 1e-9;
constexpr int kExactPassRounds = 400;
// What the second try assumes, a constant deviation of the channels.
constexpr double kCautiousNoise = 3e-4;
// Root mean square over the channels that a pixel without noise stays below.
constexpr double kNoiseFreeResidual = 1e-5;

}  // namespace

// Coordinates of a number of pixels, [coordinate][pixel], and what was minimised at them.
struct ExactPass::Ends {
  explicit Ends(std::size_t count) : coordinates(kParameterCount, count), costs(count) {}

  PixelBuffer<double> coordinates;
  std::vector<double> costs;
};

ExactPass::ExactPass(const SkinModel& model, const SpectralNodes& nodes, const Prior& prior,
                     const NoiseModel& noise, const FitOptions& options,
                     const ChannelDiscrepancy& discrepancy)
    : exact_(model, nodes, prior, noise, options, discrepancy),
      cautious_(model, nodes, prior, {kCautiousNoise, 0.0}, options, discrepancy) {
  exact_.problem().tolerance = kExactPassTolerance;
  exact_.problem().maximumRounds = kExactPassRounds;
}

void ExactPass::finish(PixelRows<const float> channels, PixelRows<float> coordinates,
                       PixelRows<float> coefficients, std::uint16_t* rounds,
                       std::uint8_t* converged) const {
  Ends ends(channels.count);
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    std::copy_n(coordinates.row(k), channels.count, ends.coordinates[k].begin());
  }
  runRefinedKernel(exact_.problem(), {channels, ends.coordinates.rows(), converged, rounds,
                                      ends.costs.data(), coefficients});
  retry(channels, ends, coefficients, rounds, converged);
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    const std::span<const double> row = ends.coordinates[k];
    std::transform(row.begin(), row.end(), coordinates.row(k),
                   [](double coordinate) { return static_cast<float>(coordinate); });
  }
}

void ExactPass::retry(PixelRows<const float> channels, Ends& ends, PixelRows<float> coefficients,
                      std::uint16_t* rounds, std::uint8_t* converged) const {
  const std::size_t channelCount = exact_.problem().channelCount;
  const double noiseFree = kNoiseFreeResidual * kNoiseFreeResidual *
                           static_cast<double>(channelCount) / exact_.problem().readVariance;
  std::vector<std::size_t> astray;
  for (std::size_t i = 0; i < channels.count; ++i) {
    if (ends.costs[i] > noiseFree) astray.push_back(i);
  }
  if (astray.empty()) return;
  const std::size_t count = astray.size();
  Ends again(count);
  PixelBuffer<float> measured(channelCount, count), start(kParameterCount, count);
  PixelBuffer<float> coefficientsAgain(coefficients.rowCount, count);
  for (std::size_t k = 0; k < channelCount; ++k) {
    for (std::size_t n = 0; n < count; ++n)
      measured[k][n] = channels.at(k, astray[n]);
  }
  std::vector<std::uint8_t> convergedAgain(count);
  std::vector<std::uint16_t> roundsAgain(count);
  cautious_.solve({measured.rows(), start.rows(), convergedAgain.data(), roundsAgain.data()});
  for (std::size_t k = 0; k < kParameterCount; ++k)
    std::copy_n(start[k].begin(), count, again.coordinates[k].begin());
  runRefinedKernel(exact_.problem(),
                   {measured.rows(), again.coordinates.rows(), convergedAgain.data(),
                    roundsAgain.data(), again.costs.data(), coefficientsAgain.rows()});
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t i = astray[n];
    rounds[i] = static_cast<std::uint16_t>(rounds[i] + roundsAgain[n]);
    if (!(again.costs[n] < ends.costs[i])) continue;
    converged[i] = convergedAgain[n];
    for (std::size_t k = 0; k < kParameterCount; ++k)
      ends.coordinates[k][i] = again.coordinates[k][n];
    for (std::size_t c = 0; c < coefficients.rowCount; ++c)
      coefficients.at(c, i) = coefficientsAgain[c][n];
  }
}

}  // namespace cutis
