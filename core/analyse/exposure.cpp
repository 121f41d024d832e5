#include "core/analyse/exposure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/analyse/pixel_sample.h"
#include "core/base/parallel.h"

namespace cutis {
namespace {

constexpr std::size_t kMostPixels = 4096;
constexpr int kStepsPerOctave = 6;
constexpr int kDarkestStep = -3 * kStepsPerOctave;
constexpr int kBrightestStep = kStepsPerOctave;
constexpr double kEqualShares = 0.01;
// A texture is left as it is unless this share of it more becomes skin.
constexpr double kWorthChanging = 0.05;

double scaleOf(int step) {
  return std::exp2(static_cast<double>(step) / kStepsPerOctave);
}

// Share of the pixels that are inside the gamut at this scale.
double insideShare(PixelSample sample, double scale, const Rig& rig, const PixelSolver& solver) {
  for (std::size_t k = 0; k < sample.channels.rowCount(); ++k) {
    for (float& value : sample.channels[k])
      value *= static_cast<float>(scale);
  }
  std::vector<PixelState> states(sample.count);
  std::vector<std::uint16_t> iterations(sample.count);
  solver.solve(sample.channels.rows(), sample.values.rows(), {states.data(), iterations.data()});
  const std::vector<double> differences = reconstructionDeltaE(rig, solver, sample);
  const auto inside = std::count_if(differences.begin(), differences.end(),
                                    [](double d) { return d <= kSameColorDeltaE; });
  return static_cast<double>(inside) / static_cast<double>(sample.count);
}

}  // namespace

Result<ExposureChoice> chooseExposure(const Measurements& measurements, const PixelSolver& solver,
                                      const JobContext& context) {
  Measurements plain = measurements;  // planes are handles
  plain.exposure = 1.0;
  CUTIS_TRY(sample, samplePixels(plain, nullptr, kMostPixels, context));
  if (sample.count == 0) return ExposureChoice{};
  sample.values = PixelBuffer<float>(solver.valueCount(), sample.count);
  const ExposureChoice unchanged = {1.0, insideShare(sample, 1.0, measurements.rig, solver)};
  if (unchanged.inside > 1.0 - kWorthChanging) return unchanged;
  constexpr auto count = static_cast<std::size_t>(kBrightestStep - kDarkestStep + 1);
  std::vector<ExposureChoice> choices(count);
  CUTIS_CHECK(parallelFor(count, context, [&](std::size_t i) -> Status {
    const double scale = scaleOf(kDarkestStep + static_cast<int>(i));
    choices[i] = {scale, insideShare(sample, scale, measurements.rig, solver)};
    return {};
  }));
  double most = 0.0;
  for (const ExposureChoice& choice : choices)
    most = std::max(most, choice.inside);
  if (most < unchanged.inside + kWorthChanging) return unchanged;
  ExposureChoice best;
  double distance = std::numeric_limits<double>::infinity();
  for (const ExposureChoice& choice : choices) {
    const double d = std::abs(std::log(choice.exposure));
    if (choice.inside <= most - kEqualShares || d >= distance) continue;
    best = choice;
    distance = d;
  }
  return best;
}

}  // namespace cutis
