#pragma once  // internal to core/fit/table

// An exact index over points of three to five features: finds what an exhaustive search finds, ties
// included, by looking at few of them.
//
// A tree of bounding boxes, eight children a node, sixteen points a leaf, split at medians across
// the widest side. Skin fills a thin, curved part of the feature space, so that a query looks at a
// few dozen leaves of the 35,764 of the full table.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/fit/table/nearest_tree_kernel.h"

namespace cutis {

// Thread-safe: const after construction.
class NearestTree {
 public:
  // features: one array per feature, all of one length. entries: which of them to index; results
  // are these numbers. Not finite features are not allowed. Cost: about 0.3 s for 572,220 on one
  // core.
  NearestTree(std::span<const std::span<const float>> features, std::vector<std::uint32_t> entries);

  // The entry with the smallest squared distance, as nearestOf() sums it; of equals the lowest.
  // A query that is not finite finds entry 0.
  std::uint32_t nearest(std::span<const float> query) const;

 private:
  struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t count() const { return end - begin; }
  };
  std::uint32_t build(const Range& range);
  std::size_t split(const Range& range);
  std::uint32_t makeLeaf(const Range& range);
  void setBox(TreeNode& node, std::size_t slot, const Range& range) const;

  int featureCount_;
  // Used only while building:
  std::vector<std::span<const float>> features_;
  std::vector<std::uint32_t> entries_;

  std::vector<TreeNode> nodes_;
  std::vector<TreeLeaf> leaves_;
};

}  // namespace cutis
