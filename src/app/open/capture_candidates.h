#pragma once

// Photographs that nobody has described yet, looked at to tell whether they are of one scene, and
// what their numbers are.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/app/open/light_guess.h"

namespace cutis {

// Three channels, as the file stores them.
struct PhotographThumbnail {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;  // interleaved, row by row
};

struct CandidatePhotograph {
  std::filesystem::path path;
  int width = 0;
  int height = 0;
  // "linear", the name of a colour space, or "raw" where what the file says cannot be named.
  std::string encoding;
  double saturatedShare = 0.0;  // of the pixels of the thumbnail; 0 for floats
  PhotographThumbnail thumbnail;
  PhotographClues clues;
};

struct CaptureCandidates {
  std::vector<CandidatePhotograph> photographs;
  // All have one size and show the same in light and dark.
  bool areOfOneScene = false;
  std::vector<std::string> colorSpaces;  // whose curves the numbers may have
};

// Reads all pixels. Errors are sentences about the first file that is no colour photograph.
Result<CaptureCandidates> inspectPhotographs(const std::vector<std::filesystem::path>& files,
                                             const JobContext& context);

// What the numbers mean as light, by an encoding as above, for the screen: red, green and blue in
// sRGB, row by row.
std::vector<std::uint8_t> screenBytes(const PhotographThumbnail& thumbnail,
                                      const std::string& encoding);

// Tiles of a texture ("skin.1001.png") or frames of a sequence: their names differ in a number of
// four digits or more alone.
bool areTilesOrFrames(const std::vector<std::filesystem::path>& files);

}  // namespace cutis
