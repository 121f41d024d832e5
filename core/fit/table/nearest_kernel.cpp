#include "core/fit/table/nearest_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fit/table/nearest_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <int kFeatures>
Nearest Search(const NearestArguments& arguments, Nearest best) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  using VI = hn::Vec<decltype(di)>;
  const std::size_t lanes = hn::Lanes(d);
  V query[kFeatures];
  for (int f = 0; f < kFeatures; ++f)
    query[f] = hn::Set(d, arguments.query[f]);
  V least = hn::Set(d, best.squaredDistance);
  VI where = hn::Set(di, -1);

  const auto visit = [&](std::size_t at, V beyond) HWY_ATTR {
    const V first = hn::Sub(hn::LoadU(d, arguments.features[0] + at), query[0]);
    V distance = hn::Mul(first, first);
    for (int f = 1; f < kFeatures; ++f) {
      const V difference = hn::Sub(hn::LoadU(d, arguments.features[f] + at), query[f]);
      distance = hn::MulAdd(difference, difference, distance);
    }
    distance = hn::Max(distance, beyond);
    const auto nearer = hn::Lt(distance, least);
    least = hn::IfThenElse(nearer, distance, least);
    where = hn::IfThenElse(hn::RebindMask(di, nearer), hn::Set(di, static_cast<int>(at)), where);
  };

  const std::size_t whole = arguments.blockSize / lanes * lanes;
  const std::size_t rest = arguments.blockSize - whole;
  // Lanes past the end of a block are infinitely far.
  const V beyond = hn::IfThenElse(hn::FirstN(d, rest), hn::Zero(d), hn::Set(d, 3.4e38f));
  for (std::size_t block = 0; block < arguments.blockCount; ++block) {
    const std::size_t begin = arguments.first + block * arguments.blockStride;
    for (std::size_t i = 0; i < whole; i += lanes)
      visit(begin + i, hn::Zero(d));
    if (rest > 0) visit(begin + whole, beyond);
  }

  HWY_ALIGN float distances[hn::MaxLanes(d)];
  HWY_ALIGN std::int32_t starts[hn::MaxLanes(d)];
  hn::Store(least, d, distances);
  hn::Store(where, di, starts);
  bool found = false;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    if (starts[lane] < 0) continue;
    const auto index = static_cast<std::uint32_t>(starts[lane]) + static_cast<std::uint32_t>(lane);
    const bool nearer = distances[lane] < best.squaredDistance;
    if (nearer || (found && distances[lane] == best.squaredDistance && index < best.index)) {
      best = {distances[lane], index};
      found = true;
    }
  }
  return best;
}

Nearest Dispatch(const NearestArguments& arguments, Nearest best) {
  switch (arguments.featureCount) {
    case 3:
      return Search<3>(arguments, best);
    case 4:
      return Search<4>(arguments, best);
    default:
      return Search<5>(arguments, best);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(Dispatch);

Nearest nearestOf(const NearestArguments& arguments, Nearest best) {
  return HWY_DYNAMIC_DISPATCH(Dispatch)(arguments, best);
}

}  // namespace cutis
#endif  // HWY_ONCE
