#include "core/fit/network_solver.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/echoed_text.h"
#include "core/neural/network_pipeline.h"
#include "core/skin/profile/profile_signature.h"

namespace cutis {
namespace {

void addScaled(const float* channel, float share, std::size_t count, float* sum) {
  if (share == 0.0f) return;
  for (std::size_t i = 0; i < count; ++i)
    sum[i] += share * channel[i];
}

class NetworkSolver final : public PixelSolver {
 public:
  NetworkSolver(const ChromophoreNetwork& network, const Eigen::MatrixXd& combination,
                std::shared_ptr<const ResponseModel> photographed)
      : PixelSolver(std::move(photographed)),
        encoder_(NetworkPipeline::encoder(network)),
        combination_(combination.cast<float>()) {}

  void solve(PixelRows<const float> channels, PixelRows<float> values,
             const SolveReport& report) const override {
    PixelBuffer<float> combined;
    encoder_.run(inputsOf(channels, combined), values, {});
    for (std::size_t i = 0; i < channels.count; ++i) {
      bool finite = true;
      for (std::size_t k = 0; k < kParameterCount; ++k)
        finite = finite && std::isfinite(values.at(k, i));
      for (std::size_t k = 0; k < kParameterCount; ++k) {
        if (!finite) values.at(k, i) = 0.0f;
      }
      report.states[i] = finite ? PixelState::solved : PixelState::noConvergence;
      report.iterations[i] = 0;
    }
  }

  // The network answers with one point.
  bool hasDeviations() const override { return false; }
  void deviations(PixelRows<const float>, PixelRows<const float>, PixelRows<float>) const override {
  }
  const char* stage() const override { return "network"; }

 private:
  PixelRows<const float> inputsOf(PixelRows<const float> channels,
                                  PixelBuffer<float>& combined) const {
    if (combination_.size() == 0) return channels;
    combined = PixelBuffer<float>(static_cast<std::size_t>(combination_.rows()), channels.count);
    for (Eigen::Index input = 0; input < combination_.rows(); ++input) {
      float* row = combined[static_cast<std::size_t>(input)].data();
      for (Eigen::Index k = 0; k < combination_.cols(); ++k)
        addScaled(channels.row(static_cast<std::size_t>(k)), combination_(input, k), channels.count,
                  row);
    }
    return combined.rows();
  }

  NetworkPipeline encoder_;
  Eigen::MatrixXf combination_;  // of the channels to the inputs; empty: they are the inputs
};

}  // namespace

Result<NetworkChannels> matchNetwork(const ChromophoreNetwork& network, const Profile& profile,
                                     const Rig& rig, const std::string& place) {
  const bool profileMatches = alike(network.profile, signatureOf(profile));
  auto channels = channelsOf(network.channels, rig);
  if (profileMatches && channels) return std::move(*channels);
  return inputError(
      place,
      "the network was trained for " +
          (profileMatches ? "other lights or another camera than those of rig " + inQuotes(rig.name)
                          : "another profile than " + inQuotes(profile.name)));
}

std::unique_ptr<const PixelSolver> makeNetworkSolver(
    const ChromophoreNetwork& network, const NetworkChannels& channels,
    std::shared_ptr<const ResponseModel> photographed) {
  return std::make_unique<NetworkSolver>(network, channels.combination, std::move(photographed));
}

}  // namespace cutis
