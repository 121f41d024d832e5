#pragma once  // internal to src/cli/commands/rig

// What a rig can tell apart, in words for people: the tables and the picture of `rig identify`.
//
// The picture is in rig_plot.cpp.

#include <string>
#include <vector>

#include "core/analyse/rig_study.h"
#include "core/base/result.h"

namespace cutis {

struct MeasurementFigures {
  std::string name;  // "all, 9 channels", "420 nm, 20 nm wide", …
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

// A study of a rig with this name on a profile, with a name for every measurement.
RigFigures namedFigures(const RigStudy& study, const std::string& rig, const std::string& profile,
                        std::size_t people);

// For people.
std::string rigTables(const RigFigures& figures);

// SVG or PNG, by the name's ending.
Status writeRigPlot(const std::string& path, const RigFigures& figures);

}  // namespace cutis
