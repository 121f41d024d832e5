#include "core/rig/narrowband.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace cutis {
namespace {

constexpr int kGreen = 1;
constexpr int kBlue = 2;

double sensorTotal(const Rig& rig, int light, int sensor) {
  return (rig.camera.sensor.sensitivity.row(sensor).transpose() *
          rig.lights[static_cast<std::size_t>(light)].power)
      .sum();
}

// The largest share of white that leaves the primary alone; nothing if the rest is not the primary
// alone or the primary is not more than white has of it.
std::optional<double> whiteShare(const RigLight& mixture, const RigLight& white, int primary) {
  if (!mixture.mix || !white.mix) return std::nullopt;
  std::optional<double> share;
  for (int i = 0; i < 3; ++i) {
    if (i == primary) continue;
    if ((*white.mix)[i] <= 0.0) {
      if ((*mixture.mix)[i] > 0.0) return std::nullopt;
      continue;
    }
    const double ratio = (*mixture.mix)[i] / (*white.mix)[i];
    if (share && std::abs(*share - ratio) > 1e-6) return std::nullopt;
    if (!share) share = ratio;
  }
  if (!share || (*mixture.mix)[primary] <= *share * (*white.mix)[primary]) return std::nullopt;
  return share;
}

// Row that gives the response to the primary alone in one sensor.
std::optional<Eigen::RowVectorXd> narrowbandRow(const Rig& rig, int white, const char* mixtureName,
                                                int sensor) {
  const int mixture = rig.lightIndex(mixtureName);
  if (mixture < 0) return std::nullopt;
  const auto share = whiteShare(rig.lights[static_cast<std::size_t>(mixture)],
                                rig.lights[static_cast<std::size_t>(white)], sensor);
  if (!share) return std::nullopt;
  const double mixtureTotal = sensorTotal(rig, mixture, sensor);
  const double whiteTotal = *share * sensorTotal(rig, white, sensor);
  if (mixtureTotal - whiteTotal <= 0.0) return std::nullopt;
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(rig.channelCount());
  row[3 * mixture + sensor] = mixtureTotal / (mixtureTotal - whiteTotal);
  row[3 * white + sensor] = -whiteTotal / (mixtureTotal - whiteTotal);
  return row;
}

}  // namespace

SearchChannels searchChannels(const Rig& rig) {
  const int white = std::max(0, rig.lightIndex("white"));
  const auto blue = narrowbandRow(rig, white, "white+blue", kBlue);
  const auto green = narrowbandRow(rig, white, "white+green", kGreen);
  const bool narrowband = blue && green;
  SearchChannels channels;
  channels.fromRig = Eigen::MatrixXd::Zero(narrowband ? 5 : 3, rig.channelCount());
  for (int c = 0; c < 3; ++c)
    channels.fromRig(c, 3 * white + c) = 1.0;
  if (narrowband) {
    channels.fromRig.row(3) = *blue;
    channels.fromRig.row(4) = *green;
  }
  return channels;
}

}  // namespace cutis
