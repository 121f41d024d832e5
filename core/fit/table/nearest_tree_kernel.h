#pragma once  // internal to core/fit/table

// Vectorised nearest neighbour in a tree of boxes. Plain data, see
// core/skin/layers/node_constants.h.

#include <cstddef>
#include <cstdint>

#include "core/fit/table/nearest_kernel.h"

namespace cutis {

inline constexpr int kTreeFanOut = 8;
inline constexpr int kTreeLeafSize = 16;

// Up to eight children with their bounding boxes. Absent children have boxes infinitely far away.
struct alignas(32) TreeNode {
  float lower[kMaximumFeatures][kTreeFanOut];
  float upper[kMaximumFeatures][kTreeFanOut];
  std::uint32_t child[kTreeFanOut];  // leaf: number with kTreeLeafBit set; else a node
};
inline constexpr std::uint32_t kTreeLeafBit = 0x80000000u;

// Sixteen entries; a leaf that is not full repeats its last one.
struct alignas(64) TreeLeaf {
  float features[kMaximumFeatures][kTreeLeafSize];
  std::uint32_t index[kTreeLeafSize];
};

struct TreeArguments {
  const TreeNode* nodes;  // the first is the root
  const TreeLeaf* leaves;
  int featureCount;  // 3, 4 or 5
  float query[kMaximumFeatures];
};

// What nearestOf() finds among the entries of the tree, to the bit: the bound of a box is summed in
// the same order as a distance, and rounding is monotone, so that no entry of a box is nearer than
// its bound. A query that is not finite finds nothing and returns index 0.
Nearest nearestInTree(const TreeArguments& arguments);

}  // namespace cutis
