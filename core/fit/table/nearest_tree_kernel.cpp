#include "core/fit/table/nearest_tree_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fit/table/nearest_tree_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Fifty levels of eight children: more than 32-bit indices can number.
constexpr int kStackSize = 50 * kTreeFanOut;

struct Pending {
  float bound;
  std::uint32_t child;
};

template <int kFeatures>
class TreeSearch {
 public:
  HWY_ATTR explicit TreeSearch(const TreeArguments& arguments) : arguments_(arguments) {}

  HWY_ATTR Nearest Run() {
    Expand(arguments_.nodes[0]);
    while (depth_ > 0) {
      const Pending next = stack_[--depth_];
      // Where both are equal, an entry in it may still come first.
      if (!(next.bound <= best_.squaredDistance)) continue;
      if ((next.child & kTreeLeafBit) != 0) {
        Visit(arguments_.leaves[next.child & ~kTreeLeafBit]);
      } else {
        Expand(arguments_.nodes[next.child]);
      }
    }
    return best_;
  }

 private:
  // Puts the children that may hold something on the stack, the nearest on top.
  HWY_ATTR void Expand(const TreeNode& node) {
    const hn::CappedTag<float, kTreeFanOut> d;
    const auto zero = hn::Zero(d);
    HWY_ALIGN float bounds[kTreeFanOut];
    for (std::size_t i = 0; i < kTreeFanOut; i += hn::Lanes(d)) {
      auto bound = zero;
      for (int f = 0; f < kFeatures; ++f) {
        const auto query = hn::Set(d, arguments_.query[f]);
        const auto below = hn::Sub(hn::Load(d, node.lower[f] + i), query);
        const auto above = hn::Sub(query, hn::Load(d, node.upper[f] + i));
        const auto outside = hn::Max(hn::Max(below, above), zero);
        bound = f == 0 ? hn::Mul(outside, outside) : hn::MulAdd(outside, outside, bound);
      }
      hn::Store(bound, d, bounds + i);
    }
    const int bottom = depth_;
    for (int c = 0; c < kTreeFanOut; ++c) {
      if (!(bounds[c] <= best_.squaredDistance)) continue;
      int at = depth_++;
      for (; at > bottom && stack_[at - 1].bound < bounds[c]; --at)
        stack_[at] = stack_[at - 1];
      stack_[at] = {bounds[c], node.child[c]};
    }
  }

  HWY_ATTR void Visit(const TreeLeaf& leaf) {
    const hn::CappedTag<float, kTreeLeafSize> d;
    for (std::size_t i = 0; i < kTreeLeafSize; i += hn::Lanes(d)) {
      auto difference = hn::Sub(hn::Load(d, leaf.features[0] + i), hn::Set(d, arguments_.query[0]));
      auto distance = hn::Mul(difference, difference);
      for (int f = 1; f < kFeatures; ++f) {
        difference = hn::Sub(hn::Load(d, leaf.features[f] + i), hn::Set(d, arguments_.query[f]));
        distance = hn::MulAdd(difference, difference, distance);
      }
      if (hn::AllFalse(d, hn::Le(distance, hn::Set(d, best_.squaredDistance)))) continue;
      HWY_ALIGN float distances[kTreeLeafSize];
      hn::Store(distance, d, distances);
      for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        Consider(distances[lane], leaf.index[i + lane]);
      }
    }
  }

  HWY_ATTR void Consider(float distance, std::uint32_t index) {
    const bool nearer = distance < best_.squaredDistance;
    if (nearer || (found_ && distance == best_.squaredDistance && index < best_.index)) {
      best_ = {distance, index};
      found_ = true;
    }
  }

  const TreeArguments& arguments_;
  Nearest best_;
  bool found_ = false;
  int depth_ = 0;
  Pending stack_[kStackSize];
};

HWY_ATTR Nearest SearchTree(const TreeArguments& arguments) {
  switch (arguments.featureCount) {
    case 3:
      return TreeSearch<3>(arguments).Run();
    case 4:
      return TreeSearch<4>(arguments).Run();
    default:
      return TreeSearch<5>(arguments).Run();
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(SearchTree);

Nearest nearestInTree(const TreeArguments& arguments) {
  return HWY_DYNAMIC_DISPATCH(SearchTree)(arguments);
}

}  // namespace cutis
#endif  // HWY_ONCE
