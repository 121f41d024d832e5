#include "core/analyse/rig_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/fit/population.h"
#include "core/rig/narrowband.h"

namespace cutis {
namespace {

constexpr std::uint64_t kSeed = 6;
constexpr std::array<double, 5> kNoises = {0.001, 0.002, 0.005, 0.01, 0.02};
constexpr std::size_t kBestLights = 8;
// Narrow lights: their middle and the width at half of their height.
constexpr int kFirstMiddleNm = 360, kLastMiddleNm = 960, kMiddleStepNm = 20;
constexpr double kHalfWidthNm = 20.0;

Spectrum narrowLight(int middleNm) {
  Spectrum power;
  for (int i = 0; i < kSampleCount; ++i) {
    const double away = (wavelengthNm(i) - middleNm) / kHalfWidthNm;
    power[i] = std::exp2(-4.0 * away * away);
  }
  return power;
}

// Whether most of a light lies where the camera sees; beyond, its curves say nothing.
bool isInSight(const RigLight& light, const Camera& camera) {
  constexpr double kBlind = 1e-3;  // of its largest sensitivity
  const Eigen::ArrayXd sees = camera.sensor.sensitivity.colwise().maxCoeff().transpose();
  const double seen = (sees > kBlind * sees.maxCoeff()).select(light.power, 0.0).sum();
  return seen > 0.5 * light.power.sum();
}

ChannelSet channelsOf(const Rig& rig) {
  return {responseRows(rig), rig.noise.isExact() ? NoiseModel() : rig.noise, {}};
}

void compareChannels(const Rig& rig, const IdentifiabilityStudy& people, RigStudy& study) {
  const ChannelSet all = channelsOf(rig);
  study.noise = all.noise;
  study.channels = static_cast<int>(all.rows.rows());
  study.all = people.of(all);
  const SearchChannels five = searchChannels(rig);
  if (five.hasNarrowband()) {
    ChannelSet combined = all;
    combined.combination = five.fromRig;
    study.paper = people.of(combined);
  }
  if (rig.lights.size() < 2) return;
  for (const RigLight& light : rig.lights) {
    Rig one = rig;
    one.lights = {light};
    study.alone.push_back({light.name, people.of(channelsOf(one))});
  }
}

void compareNoises(const Rig& rig, const IdentifiabilityStudy& people, RigStudy& study) {
  ChannelSet channels = channelsOf(rig);
  for (const double noise : kNoises) {
    channels.noise.proportional = noise;
    study.noises.push_back({noise, people.of(channels)});
  }
}

// How much is left open of everything: the mean logarithm over the parameters.
double uncertaintyOf(const Identifiability& result) {
  double sum = 0.0;
  for (const Spread& spread : result.left)
    sum += std::log(spread.median);
  return sum;
}

Status compareLights(const Rig& rig, std::span<const RigLight> candidates,
                     const IdentifiabilityStudy& people, const JobContext& context,
                     RigStudy& study) {
  double done = 0.0;
  for (const RigLight& light : candidates) {
    if (context.stopRequested()) return Cancelled{};
    context.progress.report(done++ / static_cast<double>(candidates.size()));
    if (!isInSight(light, rig.camera)) continue;
    Rig more = rig;
    more.lights.push_back(light);
    study.added.push_back({light.name, people.of(channelsOf(more))});
  }
  std::stable_sort(study.added.begin(), study.added.end(), [](const auto& a, const auto& b) {
    return uncertaintyOf(a.result) < uncertaintyOf(b.result);
  });
  study.added.resize(std::min(study.added.size(), kBestLights));
  return {};
}

}  // namespace

std::vector<RigLight> narrowLights() {
  std::vector<RigLight> lights;
  for (int nm = kFirstMiddleNm; nm <= kLastMiddleNm; nm += kMiddleStepNm)
    lights.push_back({std::to_string(nm) + " nm, 20 nm wide", narrowLight(nm), {}});
  return lights;
}

Result<RigStudy> studyRig(const SkinModel& model, const Rig& rig, const Prior& prior,
                          std::size_t people, std::span<const RigLight> candidates,
                          const JobContext& context) {
  const auto drawn = drawFromPrior(prior, model.profile().axes, static_cast<int>(people), kSeed);
  CUTIS_TRY(judges, IdentifiabilityStudy::create(model, prior, drawn, context.child(0.0, 0.1)));
  RigStudy study;
  compareChannels(rig, judges, study);
  compareNoises(rig, judges, study);
  if (static_cast<int>(rig.lights.size()) < kMaximumLights) {
    CUTIS_CHECK(compareLights(rig, candidates, judges, context.child(0.1, 1.0), study));
  }
  return study;
}

}  // namespace cutis
