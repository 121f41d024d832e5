#include "core/analyse/gamut.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cutis {

GamutStatistics gamutOf(const JudgedPixels& pixels) {
  if (pixels.count() == 0) return {};
  const auto outside = std::count(pixels.isSkin.begin(), pixels.isSkin.end(), 0);
  GamutStatistics gamut;
  gamut.outsideShare = static_cast<double>(outside) / static_cast<double>(pixels.count());
  std::vector<double> inside;
  for (std::size_t i = 0; i < pixels.deltaE.size(); ++i) {
    if (pixels.isSkin[i]) inside.push_back(pixels.deltaE[i]);
  }
  if (inside.empty()) return gamut;
  const auto middle = inside.begin() + static_cast<std::ptrdiff_t>(inside.size() / 2);
  std::nth_element(inside.begin(), middle, inside.end());
  gamut.medianDeltaE = *middle;
  return gamut;
}

}  // namespace cutis
