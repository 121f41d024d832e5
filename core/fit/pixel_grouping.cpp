#include "core/fit/pixel_grouping.h"

#include <bit>
#include <cstring>
#include <utility>

#include "core/base/random.h"

namespace cutis {
namespace {

constexpr std::size_t kSample = 1024;
// Grouping costs about a tenth of a solution.
constexpr double kWorthwhileShare = 0.1;
constexpr std::uint32_t kFree = UINT32_MAX;

class Grouper {
 public:
  Grouper(PixelRows<const float> channels, std::size_t capacity)
      : channels_(channels), slots_(std::bit_ceil(2 * capacity), kFree) {}

  // Index of the group of this pixel among `representatives`, to which it is added if new.
  std::uint32_t group(std::uint32_t pixel, std::vector<std::uint32_t>& representatives) {
    std::size_t slot = hash(pixel) & (slots_.size() - 1);
    while (slots_[slot] != kFree) {
      if (equal(representatives[slots_[slot]], pixel)) return slots_[slot];
      slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = static_cast<std::uint32_t>(representatives.size());
    representatives.push_back(pixel);
    return slots_[slot];
  }

 private:
  std::uint32_t bits(std::size_t channel, std::uint32_t pixel) const {
    return std::bit_cast<std::uint32_t>(channels_.at(channel, pixel));
  }

  std::size_t hash(std::uint32_t pixel) const {
    std::uint64_t h = 0;
    for (std::size_t k = 0; k < channels_.rowCount; ++k)
      h = mixBits(h ^ bits(k, pixel));
    return static_cast<std::size_t>(h);
  }

  bool equal(std::uint32_t a, std::uint32_t b) const {
    for (std::size_t k = 0; k < channels_.rowCount; ++k) {
      if (bits(k, a) != bits(k, b)) return false;
    }
    return true;
  }

  PixelRows<const float> channels_;
  std::vector<std::uint32_t> slots_;
};

bool sampleRepeats(PixelRows<const float> channels, const std::vector<std::uint32_t>& pixels) {
  if (pixels.size() <= kSample) return true;
  Grouper grouper(channels, kSample);
  std::vector<std::uint32_t> representatives;
  // A run of neighbours repeats colours as the whole does, far more often than scattered pixels.
  const std::size_t first = (pixels.size() - kSample) / 2;
  for (std::size_t i = 0; i < kSample; ++i)
    grouper.group(pixels[first + i], representatives);
  return static_cast<double>(representatives.size()) < (1.0 - kWorthwhileShare) * kSample;
}

}  // namespace

PixelGrouping groupEqualPixels(PixelRows<const float> channels,
                               const std::vector<std::uint32_t>& pixels, PixelGrouping reused) {
  PixelGrouping grouping = std::move(reused);
  grouping.representatives.clear();
  grouping.groupOf.clear();
  grouping.groupOf.reserve(pixels.size());
  if (!sampleRepeats(channels, pixels)) {
    grouping.representatives = pixels;
    for (std::uint32_t i = 0; i < pixels.size(); ++i)
      grouping.groupOf.push_back(i);
    return grouping;
  }
  Grouper grouper(channels, pixels.size());
  for (const std::uint32_t pixel : pixels) {
    grouping.groupOf.push_back(grouper.group(pixel, grouping.representatives));
  }
  return grouping;
}

}  // namespace cutis
