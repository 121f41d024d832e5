#pragma once

// What an image says of itself before it is opened, and what would be assumed where it says
// nothing: what a person needs to know to choose otherwise.

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"

namespace cutis {

struct LayerInspection {
  std::string name;      // as SourceOptions::layer; empty for plain channels
  std::string channels;  // "R, G, B and A"
  bool hasColors = false;
  // Whether the file and its format decide the colour space, and how, in a sentence; else why not.
  bool isDecided = false;
  std::string decision;
  std::vector<std::string> contradictions;  // a sentence each
  std::vector<std::string> statements;      // "its cICP chunk: Display P3"
};

struct ImageInspection {
  std::string format;  // "PNG, 24 × 32 pixels, 16-bit integers, with straight alpha"
  std::vector<LayerInspection> layers;   // at least one, in the order of the file
  std::size_t usualLayer = 0;            // which is read if none is chosen
  bool isLayerDecided = true;            // whether the file tells which layer is meant
  std::vector<std::string> colorSpaces;  // that can be chosen

  // Whether it opens without anybody's choice.
  bool opensByItself() const;
};

// Reads heads alone, and the configuration of OpenColorIO. Errors are sentences about the file.
Result<ImageInspection> inspectImage(const std::filesystem::path& path, const JobContext& context);

}  // namespace cutis
