#pragma once

// The layers of a picture file: which pictures it holds, found in its header alone.
//
// An OpenEXR file has parts, and a part may hold several layers, told apart by what stands before
// the last point of their channels' names: "albedo.R" is red of the layer "albedo". Files of other
// formats hold one layer. Thread-safe.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"

namespace cutis {

struct ImageLayer {
  // By which a person chooses it, unique in the file; empty for the plain channels of a file with
  // one part.
  std::string name;
  int part = 0;
  std::string prefix;                     // of its channels, "albedo."; empty for plain R, G and B
  std::vector<std::string> channelNames;  // as the file has them
  // Red, green and blue among the channels of the part; nothing if it has no colours.
  std::optional<std::array<int, 3>> colors;
  int alpha = -1;  // among the channels of the part; -1: none
};

// In the order of the file; reads no pixels. Errors are sentences about the file.
Result<std::vector<ImageLayer>> listLayers(const std::filesystem::path& path,
                                           const JobContext& context);

// "'albedo', 'diffuse' and 'Z'"; plain channels go by their own names.
std::string layerNames(const std::vector<ImageLayer>& layers);

}  // namespace cutis
