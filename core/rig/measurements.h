#pragma once

// Photographs of one subject, pixel by pixel, as a rig sees them.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/skin/pixel_state.h"

namespace cutis {

struct Measurements {
  Rig rig;
  // One plane per channel of the rig, linear, perfect diffuser = 1, all of one size; as they were
  // read, before the exposure.
  std::vector<Plane> channels;
  // storedState() of each pixel; `solved` here means that the pixel is there to be solved.
  Plane state;
  // A positive factor on all channels, for pictures that are brighter or darker than the skin
  // reflects. loadChannel() applies it, so that another exposure reads no file again; states do not
  // depend on it.
  double exposure = 1.0;
  // The skin is a model's own, which leaves nothing over (core/skin/profile/discrepancy.h).
  bool isSimulated = false;

  // A channel of a rectangle times the exposure, row by row. Precondition: as for Plane::load.
  Status loadChannel(std::size_t channel, const Rect& rect, std::span<float> values) const;

  int width() const { return state.width(); }
  int height() const { return state.height(); }
};

// What a pixel's channels say about it before any fit. `mask` zero leaves it out; `clipped` says
// that a source pixel was at the end of its range; not finite, negative and all-black are invalid.
PixelState classify(std::span<const float> channels, float mask, bool clipped);

}  // namespace cutis
