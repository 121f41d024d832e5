#include "core/fit/network_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/neural/network_pipeline.h"
#include "core/skin/pixel_state.h"
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

  void solve(const PixelBatch& batch, const SolveReport& report) const override {
    std::vector<float> combined;
    const std::vector<const float*> inputs = inputsOf(batch, combined);
    std::vector<float*> outputs;
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      outputs.push_back(batch.parameters + k * batch.stride);
    }
    encoder_.run(batch.count, inputs, outputs, {});
    for (std::size_t i = 0; i < batch.count; ++i) {
      const bool finite = std::all_of(outputs.begin(), outputs.end(),
                                      [i](const float* plane) { return std::isfinite(plane[i]); });
      for (float* plane : outputs) {
        if (!finite) plane[i] = 0.0f;
      }
      report.states[i] =
          static_cast<std::uint8_t>(finite ? PixelState::solved : PixelState::noConvergence);
      report.iterations[i] = 0;
    }
  }

  // The network answers with one point.
  bool hasDeviations() const override { return false; }
  void deviations(const PixelBatch&, float*) const override {}
  const char* stage() const override { return "network"; }

 private:
  static const float* channelOf(const PixelBatch& batch, Eigen::Index channel) {
    return batch.channels + static_cast<std::size_t>(channel) * batch.stride;
  }

  std::vector<const float*> inputsOf(const PixelBatch& batch, std::vector<float>& combined) const {
    std::vector<const float*> inputs;
    if (combination_.size() == 0) {
      for (int k = 0; k < channelCount(); ++k)
        inputs.push_back(channelOf(batch, k));
      return inputs;
    }
    combined.assign(static_cast<std::size_t>(combination_.rows()) * batch.count, 0.0f);
    for (Eigen::Index input = 0; input < combination_.rows(); ++input) {
      float* plane = combined.data() + static_cast<std::size_t>(input) * batch.count;
      for (Eigen::Index k = 0; k < combination_.cols(); ++k)
        addScaled(channelOf(batch, k), combination_(input, k), batch.count, plane);
      inputs.push_back(plane);
    }
    return inputs;
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
          (profileMatches ? "other lights or another camera than those of rig '" + rig.name + "'"
                          : "another profile than '" + profile.name + "'"));
}

std::unique_ptr<const PixelSolver> makeNetworkSolver(
    const ChromophoreNetwork& network, const NetworkChannels& channels,
    std::shared_ptr<const ResponseModel> photographed) {
  return std::make_unique<NetworkSolver>(network, channels.combination, std::move(photographed));
}

}  // namespace cutis
