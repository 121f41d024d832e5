#include "core/fit/network_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/neural/network_pipeline.h"
#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

class NetworkSolver final : public PixelSolver {
 public:
  NetworkSolver(const ChromophoreNetwork& network, std::shared_ptr<const ResponseModel> channels)
      : PixelSolver(std::move(channels)), encoder_(NetworkPipeline::encoder(network)) {}

  void solve(const PixelBatch& batch, const SolveReport& report) const override {
    std::vector<const float*> inputs;
    for (int k = 0; k < channelCount(); ++k) {
      inputs.push_back(batch.channels + static_cast<std::size_t>(k) * batch.stride);
    }
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
  NetworkPipeline encoder_;
};

}  // namespace

std::string trainingCommand(const Profile& profile, const Rig& rig) {
  std::string lights;
  for (const RigLight& light : rig.lights)
    lights += (lights.empty() ? "" : ",") + light.name;
  return "cutis-cli train --rig " + rig.name + " --lights " + lights + " --profile " +
         profile.name + " -o WEIGHTS.json";
}

Status checkNetworkMatches(const ChromophoreNetwork& network, const Profile& profile,
                           const Rig& rig, const std::string& place) {
  const bool profileMatches = network.profile == fingerprint(profile);
  if (profileMatches && network.channels == fingerprint(networkChannels(rig))) return {};
  return inputError(
      place,
      "the network was trained for " +
          (profileMatches ? "other lights or another camera than those of rig '" + rig.name + "'"
                          : "another profile than '" + profile.name + "'") +
          "; train one with " + trainingCommand(profile, rig));
}

std::unique_ptr<const PixelSolver> makeNetworkSolver(
    const ChromophoreNetwork& network, std::shared_ptr<const ResponseModel> channels) {
  return std::make_unique<NetworkSolver>(network, std::move(channels));
}

}  // namespace cutis
