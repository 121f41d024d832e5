#pragma once  // internal to core/fit/table

// Vectorised nearest neighbour by exhaustive search. Plain data, see
// core/skin/layers/node_constants.h.

#include <cstddef>
#include <cstdint>

namespace cutis {

inline constexpr int kMaximumFeatures = 5;

struct Nearest {
  float squaredDistance = 3.4e38f;
  std::uint32_t index = 0;
};

struct NearestArguments {
  const float*
      features[kMaximumFeatures];  // one array per feature, readable 16 floats past the end
  int featureCount;                // 3, 4 or 5
  // Candidates: blockCount blocks of blockSize entries, blockStride apart.
  std::size_t first;
  std::size_t blockSize;
  std::size_t blockStride;
  std::size_t blockCount;
  float query[kMaximumFeatures];
};

// The candidate with the smallest squared Euclidean distance, of equals the one with the lowest
// index, if it is nearer than `best` (on equality `best` stays). Distances are summed feature by
// feature with fused multiply-add: every caller gets the same bits.
Nearest nearestOf(const NearestArguments& arguments, Nearest best);

}  // namespace cutis
