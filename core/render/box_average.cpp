#include "core/render/box_average.h"

#include <algorithm>
#include <cstddef>

namespace cutis {
namespace {

// The sums of a row of blocks.
struct BlockSums {
  std::vector<std::vector<float>> channels;
  std::vector<float> counts;
};

void addRow(const PictureBuffer& picture, int y, int step, BlockSums& sums) {
  const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width);
  for (int x = 0; x < picture.width; ++x) {
    const std::size_t i = row + static_cast<std::size_t>(x);
    if (!picture.present[i]) continue;
    const auto block = static_cast<std::size_t>(x / step);
    sums.counts[block] += 1.0f;
    for (std::size_t c = 0; c < sums.channels.size(); ++c)
      sums.channels[c][block] += picture.channels[c][i];
  }
}

}  // namespace

PictureBuffer boxAverage(const PictureBuffer& picture, int step) {
  PictureBuffer averaged;
  averaged.width = (picture.width + step - 1) / step;
  averaged.height = (picture.height + step - 1) / step;
  averaged.channels.resize(picture.channels.size());
  const auto width = static_cast<std::size_t>(averaged.width);
  for (int top = 0; top < picture.height; top += step) {
    BlockSums sums = {std::vector(picture.channels.size(), std::vector<float>(width)),
                      std::vector<float>(width)};
    for (int y = top; y < std::min(top + step, picture.height); ++y)
      addRow(picture, y, step, sums);
    for (std::size_t block = 0; block < width; ++block) {
      const float count = sums.counts[block];
      averaged.present.push_back(count > 0.0f);
      for (std::size_t c = 0; c < sums.channels.size(); ++c)
        averaged.channels[c].push_back(count > 0.0f ? sums.channels[c][block] / count : 0.0f);
    }
  }
  return averaged;
}

}  // namespace cutis
