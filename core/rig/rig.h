#pragma once

// A rig: the camera and the lights a face was photographed with. It maps a reflectance spectrum to
// measured channels,
//
//   channel(light k, sensor c) = Σ R S_c L_k / Σ S_c L_k   over the wavelength grid,
//
// so that a perfect diffuser reads 1 in every channel. Channels are numbered light by light, and in
// each light in the order of the sensor's three curves.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/spectra/colorimetry.h"
#include "core/spectra/grid.h"

namespace cutis {

struct Camera {
  std::string name;
  Sensor sensor;
  std::array<std::string, 3> channelNames = {"R", "G", "B"};  // "X", "Y", "Z" for an observer
  // A colour-matching observer: pictures in a colour space are its measurements.
  bool isObserver = false;
};

struct RigLight {
  std::string name;
  Spectrum power = Spectrum::Zero();  // relative
  // Shares of the rig's display primaries, if the light is a mix of them.
  std::optional<Eigen::Vector3d> mix;
};

// Standard deviations of a channel; the perfect diffuser reads 1. The variances add:
// read² + (proportional · (channel + veil))².
struct NoiseModel {
  double read = 0.0001;
  double proportional = 0.005;
  // Light that was measured with the channel and then taken off it, while its noise stayed.
  double veil = 0.0;

  // Zero noise asks for the exact solution.
  bool isExact() const { return read == 0.0 && proportional == 0.0; }
  double variance(double channel) const {
    const double varying = proportional * (channel + veil);
    return read * read + varying * varying;
  }
};

// The fit keeps the channels of all lights in registers.
inline constexpr int kMaximumLights = 10;

struct Rig {
  std::string name;
  std::string file;  // that it was read from; empty: it is built in
  Camera camera;
  std::vector<RigLight> lights;
  NoiseModel noise;

  int channelCount() const { return 3 * static_cast<int>(lights.size()); }
  // "white.R", "white+blue.G", …
  std::string channelName(int channel) const;
  // Index into lights; -1 if there is none of that name.
  int lightIndex(const std::string& lightName) const;
};

// Checks that there are lights and not too many, that names differ, that no power, sensitivity or
// noise is negative or not finite. A channel that sees nothing is allowed; it is left out of a fit.
Status validate(const Rig& rig, const std::string& place);

// The same rig with only these lights, in this order. Fails if there is none, or a name is unknown
// or given twice.
Result<Rig> withLights(const Rig& rig, const std::vector<std::string>& names,
                       const std::string& place);

// The channels as rows over the grid; each sums to 1, or is all zero for a channel that sees
// nothing.
SpectrumRows responseRows(const Rig& rig);

// Identifies everything that changes a channel. Names and noise are not part of it.
std::string fingerprint(const Rig& rig);

}  // namespace cutis
