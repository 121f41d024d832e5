// The value below which a share of a population lies, by rank: no interpolation, so that the answer
// is one of the values.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace cutis {

// values: at least one, none of them NaN; reordered. share: 0 … 1. The rank is rounded down. Cost
// is linear.
template <typename T>
T quantileOf(std::vector<T>& values, double share) {
  assert(!values.empty());
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace cutis
