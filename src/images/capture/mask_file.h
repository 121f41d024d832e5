#pragma once

// Masks: pictures of which pixels count. 0 leaves a pixel out, 1 includes it; between the two an
// edit blends and a fit solves.

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/rect.h"
#include "core/base/result.h"
#include "src/images/pixels/orientation.h"

namespace cutis {

// What a mask is for.
struct MaskedPicture {
  int width = 0;
  int height = 0;
  std::string name;  // in sentences: "'white.exr'"
  // The part that is shown; empty: all of it. A mask of this size belongs there, and leaves out
  // what lies around it.
  Rect display = {};
  // How the picture lies in its file. A mask that lies the same way is turned along with it.
  Orientation orientation = Orientation::upright;
};

// The mask in an image of any kind: its alpha where there is a shape in it, else the only colour
// with a shape in it, else the luminance of its colours; clamped to [0, 1], NaN counts as 0.
// Colours count as they are stored, without a colour space. A notice says which of several shapes
// was taken, and that a mask is empty or full. An input error if the size does not fit.
Result<Plane> readMask(const std::filesystem::path& path, const MaskedPicture& picture,
                       const std::shared_ptr<TileStore>& store, const JobContext& context);

}  // namespace cutis
