#include "core/simulate/backdrop.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/simulate/paint/gradient_noise.h"

namespace cutis {
namespace {

enum BackdropStream : std::uint64_t { kFolds = 700, kWeave };

constexpr float kDarkest = 0.03f;
constexpr float kLightest = 0.08f;

// Falls towards the red by half, on average 1 over the visible.
Spectrum tint() {
  Spectrum tint;
  for (int i = 0; i < kSampleCount; ++i) {
    tint[i] = 1.0 - 0.35 * std::clamp((wavelengthNm(i) - 550.0) / 150.0, -1.0, 1.0);
  }
  return tint;
}

}  // namespace

Backdrop::Backdrop(const Rig& rig, int width, int height, std::uint64_t seed)
    : width_(width), height_(height), seed_(seed) {
  const Spectrum spectrum = tint();
  const SpectrumRows rows = responseRows(rig);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    channels_.push_back(static_cast<float>((rows.row(k).transpose() * spectrum).sum()));
  }
}

std::vector<float> Backdrop::level(const Rect& rect) const {
  const PatchFrame frame = {width_, height_};
  FractalRows folds({0.18, 0.5, 3, 0.5}, noiseKey(seed_, kFolds), frame, rect);
  FractalRows weave({0.06, 0.008, 2, 0.8}, noiseKey(seed_, kWeave), frame, rect);
  const auto columns = static_cast<std::size_t>(rect.width());
  std::vector<float> levels(rect.pixelCount());
  std::vector<float> fold(columns), thread(columns);
  for (int y = rect.y0; y < rect.y1; ++y) {
    folds.row(y, fold.data());
    weave.row(y, thread.data());
    float* out = levels.data() + static_cast<std::size_t>(y - rect.y0) * columns;
    // Light falls from above.
    const float lit = 0.055f - 0.02f * (static_cast<float>(y) + 0.5f) / static_cast<float>(height_);
    for (std::size_t x = 0; x < columns; ++x) {
      out[x] = std::clamp(lit * (1.0f + fold[x]) * (1.0f + thread[x]), kDarkest, kLightest);
    }
  }
  return levels;
}

}  // namespace cutis
