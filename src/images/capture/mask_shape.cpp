#include "src/images/capture/mask_shape.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <mutex>
#include <optional>
#include <span>

#include "core/base/parallel.h"

namespace cutis {
namespace {

// The shares of Rec.709's primaries.
constexpr std::array<float, 3> kLuminance = {0.2126f, 0.7152f, 0.0722f};

// Values apart from each other by less than any sample type tells apart are one value.
constexpr float kSameValue = 1e-6f;

float clamped(float value) {
  return value > 0.0f ? std::min(value, 1.0f) : 0.0f;  // NaN, too
}

struct Range {
  float least = std::numeric_limits<float>::infinity();
  float most = -std::numeric_limits<float>::infinity();

  void add(float value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  void add(const Range& other) {
    least = std::min(least, other.least);
    most = std::max(most, other.most);
  }
  bool varies() const { return most - least > kSameValue; }
};

struct Spread {
  std::vector<Range> colors;
  Range alpha;
  // The range of the first colour where alpha is not 0.
  Range covered;
  bool grey = true;
};

using Values = std::vector<std::vector<float>>;

Result<Values> loadTile(const MaskChannels& channels, const Rect& rect) {
  Values values;
  for (const Plane& color : channels.colors) {
    values.emplace_back(rect.pixelCount());
    CUTIS_CHECK(color.load(rect, values.back()));
  }
  values.emplace_back(rect.pixelCount(), 1.0f);
  if (!channels.alpha.empty()) CUTIS_CHECK(channels.alpha.load(rect, values.back()));
  for (std::vector<float>& channel : values)
    std::transform(channel.begin(), channel.end(), channel.begin(), clamped);
  return values;
}

Spread spreadOf(const Values& values) {
  const std::size_t colors = values.size() - 1;
  const std::vector<float>& alpha = values.back();
  Spread spread;
  spread.colors.resize(colors);
  for (std::size_t p = 0; p < alpha.size(); ++p) {
    spread.alpha.add(alpha[p]);
    if (alpha[p] > 0.0f) spread.covered.add(values[0][p]);
    for (std::size_t c = 0; c < colors; ++c) {
      spread.colors[c].add(values[c][p]);
      spread.grey = spread.grey && values[c][p] - values[0][p] <= kSameValue &&
                    values[0][p] - values[c][p] <= kSameValue;
    }
  }
  return spread;
}

void merge(const Spread& part, Spread& whole) {
  whole.colors.resize(part.colors.size());
  for (std::size_t c = 0; c < part.colors.size(); ++c)
    whole.colors[c].add(part.colors[c]);
  whole.alpha.add(part.alpha);
  whole.covered.add(part.covered);
  whole.grey = whole.grey && part.grey;
}

Result<Spread> measure(const MaskChannels& channels, const JobContext& context) {
  const Plane& size = channels.colors.front();
  Spread whole;
  std::mutex mutex;
  CUTIS_CHECK(parallelFor(static_cast<std::size_t>(size.tileCount()), {context.stop, {}, {}},
                          [&](std::size_t i) -> Status {
                            CUTIS_TRY(values,
                                      loadTile(channels, size.tileRect(static_cast<int>(i))));
                            const Spread part = spreadOf(values);
                            const std::scoped_lock lock(mutex);
                            merge(part, whole);
                            return {};
                          }));
  return whole;
}

// Which channel of the values is the mask; none: the luminance of all three.
std::optional<std::size_t> channelOf(const Spread& spread, FoundMask& found) {
  const std::size_t colors = spread.colors.size();
  if (spread.alpha.varies()) {
    found.shape = MaskShape::alpha;
    found.colorsDiffer = spread.covered.varies();
    return colors;
  }
  const auto varies = [](const Range& range) { return range.varies(); };
  const auto varying = std::count_if(spread.colors.begin(), spread.colors.end(), varies);
  if (varying > 0) found.shape = MaskShape::luminance;
  if (colors < 3 || spread.grey) return 0;
  if (varying == 1) {
    found.shape = MaskShape::oneColor;
    return static_cast<std::size_t>(
        std::find_if(spread.colors.begin(), spread.colors.end(), varies) - spread.colors.begin());
  }
  found.isColored = true;
  return std::nullopt;
}

std::vector<float> luminanceOf(const Values& values) {
  std::vector<float> luminance(values.front().size(), 0.0f);
  for (std::size_t c = 0; c < kLuminance.size(); ++c) {
    for (std::size_t p = 0; p < luminance.size(); ++p)
      luminance[p] += kLuminance[c] * values[c][p];
  }
  std::transform(luminance.begin(), luminance.end(), luminance.begin(), clamped);
  return luminance;
}

}  // namespace

Result<FoundMask> findMask(const MaskChannels& channels, Plane& mask, const JobContext& context) {
  FoundMask found;
  CUTIS_TRY(spread, measure(channels, context));
  const std::optional<std::size_t> channel = channelOf(spread, found);
  Range range;
  std::mutex mutex;
  CUTIS_CHECK(parallelFor(static_cast<std::size_t>(mask.tileCount()), {context.stop, {}, {}},
                          [&](std::size_t i) -> Status {
                            const Rect rect = mask.tileRect(static_cast<int>(i));
                            CUTIS_TRY(values, loadTile(channels, rect));
                            const std::vector<float> tile =
                                channel ? values[*channel] : luminanceOf(values);
                            Range part;
                            for (const float value : tile)
                              part.add(value);
                            {
                              const std::scoped_lock lock(mutex);
                              range.add(part);
                            }
                            return mask.store(rect, tile);
                          }));
  found.isEmpty = range.most <= 0.0f;
  found.isFull = range.least >= 1.0f;
  return found;
}

}  // namespace cutis
