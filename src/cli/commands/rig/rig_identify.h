#pragma once

// What a rig can tell apart, as numbers: for the table and the picture of `rig identify`.

#include <string>
#include <vector>

#include "core/analyse/identifiability.h"
#include "src/cli/command.h"

namespace cutis {

struct MeasurementFigures {
  std::string name;  // "all 9 channels", "with 420 nm", …
  Identifiability result;
};

struct RigFigures {
  std::string rig;
  std::string profile;
  std::size_t people = 0;
  NoiseModel noise;
  std::vector<MeasurementFigures> channels;  // all of them first, then parts
  std::vector<MeasurementFigures> noises;    // all channels, other proportional noise
  std::vector<MeasurementFigures> lights;    // one more light, the best first
};

// people: drawn from the prior. Cancelled if asked to stop.
Result<RigFigures> identifyRig(const SkinModel& model, const Rig& rig, const Prior& prior,
                               std::size_t people, const JobContext& context);

// For people.
std::string rigTables(const RigFigures& figures);

// SVG or PNG, by the name's ending.
Status writeRigPlot(const std::string& path, const RigFigures& figures);

}  // namespace cutis
