#pragma once

// Weighted sums of many columns at once: a small matrix times a wide one, vectorised.
//
// Plain data, see core/skin/layers/node_constants.h. A column's result is its own, whatever stands
// beside it.

#include <cstddef>

namespace cutis {

struct WeightedSums {
  const double* weights;  // [row][term]
  std::size_t rowCount, termCount;
  const double* values;  // [term][column]
  std::size_t columnCount;
  double* sums;  // [row][column]: Σ over the terms, in their order
};

// Thread-safe. NaN stays in its column.
void runWeightedSums(const WeightedSums& arguments);

}  // namespace cutis
