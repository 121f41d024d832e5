#include "core/fit/refined/fast_pass.h"

#include "core/fit/refined/start_polynomial.h"

namespace cutis {
namespace {

// A pixel is done when the next step would lower its cost by less than this: the step it then takes
// leaves a few hundredths of a posterior deviation.
constexpr double kFastPassTolerance = 0.03;

}  // namespace

FastPass::FastPass(const SkinModel& model, const SpectralNodes& nodes, const Prior& prior,
                   const NoiseModel& noise, const FitOptions& options,
                   const ChannelDiscrepancy& discrepancy)
    : data_(model, nodes, prior, noise, options, discrepancy) {
  data_.problem().tolerance = static_cast<float>(kFastPassTolerance);
  const auto solveFrom = [this](const StartPolynomial& start, PixelRows<const float> channels,
                                PixelRows<float> coordinates) {
    std::vector<std::uint8_t> converged(channels.count);
    std::vector<std::uint16_t> rounds(channels.count);
    data_.problem().start = &start;
    solve({channels, coordinates, converged.data(), rounds.data()});
  };
  start_ = trainStartPolynomial(
      {model, nodes, prior, noise, options.fixed, options.shading.value_or(0.0), discrepancy},
      solveFrom);
  data_.problem().start = &start_;
}

}  // namespace cutis
