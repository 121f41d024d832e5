#pragma once

// What a rig can tell apart of skin, and what would help: all its channels against parts of them,
// with other noise, and with one more light.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analyse/identifiability.h"
#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/prior.h"

namespace cutis {

struct LightFigures {
  std::string light;
  Identifiability result;
};

struct NoiseFigures {
  double proportional = 0.0;
  Identifiability result;
};

struct RigStudy {
  NoiseModel noise;  // assumed for all but `noises`
  int channels = 0;  // of all lights
  Identifiability all;
  std::optional<Identifiability> paper;  // of r, g, b, sb, sg; where the rig has them
  std::vector<LightFigures> alone;       // each light by itself, of a rig with several
  std::vector<NoiseFigures> noises;      // all channels, other proportional noise
  std::vector<LightFigures> added;       // one more light, the best few, the best first
};

// Light-emitting diodes every 20 nm from 360 to 960 nm, 20 nm wide at half of their height, named
// "360 nm, 20 nm wide".
std::vector<RigLight> narrowLights();

// people: drawn from the prior, with which anything is estimated. candidates: lights to add, those
// beyond the camera's sight are passed over; none is added to a rig of kMaximumLights. About 0.1 ms
// a person and core and 20 µs more for each measurement compared. Cancelled if asked to stop.
Result<RigStudy> studyRig(const SkinModel& model, const Rig& rig, const Prior& prior,
                          std::size_t people, std::span<const RigLight> candidates,
                          const JobContext& context);

}  // namespace cutis
