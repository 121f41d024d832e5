#include "src/bench/figures.h"

#include <algorithm>

namespace cutis {

Coverage::Count pooled(const std::array<Coverage::Count, kParameterCount>& counts) {
  Coverage::Count all;
  for (const Coverage::Count& count : counts) {
    all.pixels += count.pixels;
    all.inside += count.inside;
  }
  return all;
}

const MethodFigures* figuresOf(const std::vector<MethodFigures>& all, BenchMethod method,
                               double noise) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const MethodFigures& figures) {
    return figures.method == method && figures.noise == noise;
  });
  return found == all.end() ? nullptr : &*found;
}

const PictureFigures* largestPicture(const BenchFigures& figures, BenchMethod method) {
  const PictureFigures* found = nullptr;
  for (const PictureFigures& row : figures.sizes) {
    const bool fits =
        row.method == method && row.content == "uncorrelated" && row.size <= kUsualSize;
    if (!fits) continue;
    // What was run before what was scaled, then the larger one.
    const bool better = found == nullptr || (found->scaled && !row.scaled) ||
                        (found->scaled == row.scaled && row.size > found->size);
    if (better) found = &row;
  }
  return found;
}

double usualScaling(int size) {
  return 1.0 * kUsualSize * kUsualSize / (1.0 * size * size);
}

std::optional<double> usualSeconds(const BenchFigures& figures, BenchMethod method) {
  const auto* row = largestPicture(figures, method);
  if (row == nullptr) return {};
  return usualScaling(row->size) * row->seconds;
}

}  // namespace cutis
