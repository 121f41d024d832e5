#include "src/images/pixels/alpha.h"

#include <cassert>
#include <cstddef>

namespace cutis {

void divideByAlpha(std::span<float> color, std::span<const float> alpha) {
  assert(color.size() == alpha.size());
  for (std::size_t i = 0; i < color.size(); ++i) {
    if (alpha[i] != 0.0f && alpha[i] != 1.0f) color[i] /= alpha[i];
  }
}

void multiplyByAlpha(std::span<float> color, std::span<const float> alpha) {
  assert(color.size() == alpha.size());
  for (std::size_t i = 0; i < color.size(); ++i) {
    if (alpha[i] != 0.0f) color[i] *= alpha[i];
  }
}

}  // namespace cutis
