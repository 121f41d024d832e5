#pragma once

// From values to places along an axis, and the round values to write beside it.

#include <vector>

namespace cutis {

struct Scale {
  double from = 0.0, to = 1.0;    // values; positive where logarithmic
  double begin = 0.0, end = 1.0;  // their places
  bool logarithmic = false;

  // Values beyond the ends, NaN among them, are put at the ends.
  double at(double value) const;
};

// 1, 2 and 5 times powers of ten around the values, which are positive: as few as hold them all.
std::vector<double> logarithmicTicks(double least, double most);
// From 0 to at or beyond `most`, in at most five round steps.
std::vector<double> linearTicks(double most);

}  // namespace cutis
