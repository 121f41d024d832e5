#include "core/fit/table/nearest_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cutis {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

std::size_t roundedUp(std::size_t value, std::size_t step) {
  return (value + step - 1) / step * step;
}

}  // namespace

NearestTree::NearestTree(std::span<const std::span<const float>> features,
                         std::vector<std::uint32_t> entries)
    : featureCount_(static_cast<int>(features.size())),
      features_(features.begin(), features.end()),
      entries_(std::move(entries)) {
  leaves_.reserve(entries_.size() / kTreeLeafSize + 1);
  build({0, entries_.size()});
  features_ = {};
  entries_ = {};
}

// Puts the entries of the range in two parts and returns where the second begins: a multiple of the
// leaf size from the first, so that only the last leaf of a tree is not full.
std::size_t NearestTree::split(const Range& range) {
  std::size_t widest = 0;
  float width = -1.0f;
  for (std::size_t f = 0; f < features_.size(); ++f) {
    float lower = kFar, upper = -kFar;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      lower = std::min(lower, features_[f][entries_[i]]);
      upper = std::max(upper, features_[f][entries_[i]]);
    }
    if (upper - lower > width) {
      width = upper - lower;
      widest = f;
    }
  }
  const std::size_t middle = range.begin + roundedUp(range.count() / 2, kTreeLeafSize);
  const auto at = [&](std::size_t i) { return entries_.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::span<const float> key = features_[widest];
  std::nth_element(at(range.begin), at(middle), at(range.end),
                   [key](std::uint32_t a, std::uint32_t b) {
                     return key[a] != key[b] ? key[a] < key[b] : a < b;
                   });
  return middle;
}

std::uint32_t NearestTree::build(const Range& range) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  std::vector<Range> parts = {range};
  for (int level = 1; level < kTreeFanOut; level *= 2) {
    std::vector<Range> halves;
    for (const Range& part : parts) {
      if (part.count() <= kTreeLeafSize) {
        halves.push_back(part);
        continue;
      }
      const std::size_t middle = split(part);
      halves.push_back({part.begin, middle});
      halves.push_back({middle, part.end});
    }
    parts = std::move(halves);
  }
  TreeNode node = {};
  for (std::size_t slot = 0; slot < kTreeFanOut; ++slot) {
    setBox(node, slot, slot < parts.size() ? parts[slot] : Range{});
    if (slot >= parts.size()) continue;
    node.child[slot] = parts[slot].count() <= kTreeLeafSize ? makeLeaf(parts[slot]) | kTreeLeafBit
                                                            : build(parts[slot]);
  }
  nodes_[number] = node;
  return number;
}

std::uint32_t NearestTree::makeLeaf(const Range& range) {
  TreeLeaf leaf = {};
  for (std::size_t i = 0; i < kTreeLeafSize; ++i) {
    const std::uint32_t entry = entries_[std::min(range.begin + i, range.end - 1)];
    for (std::size_t f = 0; f < features_.size(); ++f)
      leaf.features[f][i] = features_[f][entry];
    leaf.index[i] = entry;
  }
  leaves_.push_back(leaf);
  return static_cast<std::uint32_t>(leaves_.size() - 1);
}

void NearestTree::setBox(TreeNode& node, std::size_t slot, const Range& range) const {
  for (std::size_t f = 0; f < features_.size(); ++f) {
    float lower = kFar, upper = -kFar;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      lower = std::min(lower, features_[f][entries_[i]]);
      upper = std::max(upper, features_[f][entries_[i]]);
    }
    node.lower[f][slot] = lower;
    node.upper[f][slot] = upper;
  }
}

std::uint32_t NearestTree::nearest(std::span<const float> query) const {
  if (!std::all_of(query.begin(), query.end(), [](float x) { return std::isfinite(x); })) return 0;
  TreeArguments arguments = {};
  arguments.nodes = nodes_.data();
  arguments.leaves = leaves_.data();
  arguments.featureCount = featureCount_;
  std::copy(query.begin(), query.end(), arguments.query);
  return nearestInTree(arguments).index;
}

}  // namespace cutis
