#pragma once  // internal to src/images/preview

// A JPEG at a fraction of its resolution, by its own transform: each pixel stands for a square of
// reduction × reduction pixels, and most of the work of decoding them is left out.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/job_context.h"

namespace cutis {

struct ReducedJpeg {
  int width = 0;
  int height = 0;
  int channels = 3;                   // or 1: grey
  std::vector<std::uint8_t> samples;  // row by row, the channels of a pixel beside each other
};

// As it lies in the file. Nothing for what is damaged, for inks and when asked to stop: whoever
// reads all of the file learns why. Precondition: reduction is 1, 2, 4 or 8.
std::optional<ReducedJpeg> readReducedJpeg(const std::filesystem::path& path, int reduction,
                                           const JobContext& context);

}  // namespace cutis
