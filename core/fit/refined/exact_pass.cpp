#include "core/fit/refined/exact_pass.h"

#include <algorithm>
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
struct ExactPass::Pixels {
  explicit Pixels(std::size_t pixelCount)
      : count(pixelCount), coordinates(kParameterCount * pixelCount), costs(pixelCount) {}

  std::size_t count;
  std::vector<double> coordinates;
  std::vector<double> costs;
};

ExactPass::ExactPass(const SkinModel& model, const SpectralNodes& nodes, const Prior& prior,
                     const NoiseModel& noise, const FitOptions& options)
    : exact_(model, nodes, prior, noise, options),
      cautious_(model, nodes, prior, {kCautiousNoise, 0.0}, options) {
  exact_.problem().tolerance = kExactPassTolerance;
  exact_.problem().maximumRounds = kExactPassRounds;
}

void ExactPass::finish(const PixelBatch& batch, std::uint16_t* rounds,
                       std::uint8_t* converged) const {
  Pixels pixels(batch.count);
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    std::copy_n(batch.parameters + k * batch.stride, batch.count,
                pixels.coordinates.data() + k * batch.count);
  }
  // The kernel has one stride for channels and coordinates.
  std::vector<float> channels(exact_.problem().channelCount * batch.count);
  for (std::size_t k = 0; k < exact_.problem().channelCount; ++k) {
    std::copy_n(batch.channels + k * batch.stride, batch.count, channels.data() + k * batch.count);
  }
  const PixelBatch packed = {batch.count, batch.count, channels.data(), nullptr};
  runRefinedKernel(exact_.problem(),
                   {packed.count, packed.stride, packed.channels, pixels.coordinates.data(),
                    converged, rounds, pixels.costs.data()});
  retry(packed, pixels, rounds, converged);
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    std::transform(pixels.coordinates.begin() + static_cast<std::ptrdiff_t>(k * batch.count),
                   pixels.coordinates.begin() + static_cast<std::ptrdiff_t>((k + 1) * batch.count),
                   batch.parameters + k * batch.stride,
                   [](double coordinate) { return static_cast<float>(coordinate); });
  }
}

void ExactPass::retry(const PixelBatch& batch, Pixels& pixels, std::uint16_t* rounds,
                      std::uint8_t* converged) const {
  const std::size_t channelCount = exact_.problem().channelCount;
  const double noiseFree = kNoiseFreeResidual * kNoiseFreeResidual *
                           static_cast<double>(channelCount) / exact_.problem().readVariance;
  std::vector<std::size_t> astray;
  for (std::size_t i = 0; i < batch.count; ++i) {
    if (pixels.costs[i] > noiseFree) astray.push_back(i);
  }
  if (astray.empty()) return;
  Pixels again(astray.size());
  std::vector<float> channels(channelCount * again.count), start(kParameterCount * again.count);
  for (std::size_t k = 0; k < channelCount; ++k) {
    for (std::size_t n = 0; n < again.count; ++n)
      channels[k * again.count + n] = batch.channels[k * batch.stride + astray[n]];
  }
  std::vector<std::uint8_t> convergedAgain(again.count);
  std::vector<std::uint16_t> roundsAgain(again.count);
  cautious_.solve({again.count, again.count, channels.data(), start.data(), convergedAgain.data(),
                   roundsAgain.data()});
  std::copy(start.begin(), start.end(), again.coordinates.begin());
  runRefinedKernel(exact_.problem(),
                   {again.count, again.count, channels.data(), again.coordinates.data(),
                    convergedAgain.data(), roundsAgain.data(), again.costs.data()});
  for (std::size_t n = 0; n < again.count; ++n) {
    const std::size_t i = astray[n];
    rounds[i] = static_cast<std::uint16_t>(rounds[i] + roundsAgain[n]);
    if (!(again.costs[n] < pixels.costs[i])) continue;
    converged[i] = convergedAgain[n];
    for (std::size_t k = 0; k < kParameterCount; ++k)
      pixels.coordinates[k * batch.count + i] = again.coordinates[k * again.count + n];
  }
}

}  // namespace cutis
