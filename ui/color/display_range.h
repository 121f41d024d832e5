#pragma once

// What the ends of a false-colour scale stand for, and where a value lies between them.
//
// Thread-safe: pure functions.

#include <vector>

namespace cutis {

struct DisplayRange {
  double minimum = 0.0;
  double maximum = 1.0;
  bool isLogarithmic = false;  // with both ends above 0

  bool operator==(const DisplayRange&) const = default;
};

// 0 at the minimum and 1 at the maximum, beyond them less and more. Of a logarithmic range what is
// not above 0 lies at minus infinity; NaN stays NaN.
class PositionIn {
 public:
  explicit PositionIn(const DisplayRange& range);
  double operator()(double value) const;

 private:
  bool isLogarithmic_;
  double offset_;
  double factor_;
};

// The inverse.
double valueAt(const DisplayRange& range, double position);

// In which the values, in ascending order, can be told apart: from the 1st to the 99th of a
// hundred (core/analyse/skin_values.h); from 0 to 1 where there are none.
DisplayRange rangeOfValues(const std::vector<float>& sorted, bool isLogarithmic);

// What a bar shows around the range, so that its ends can be drawn outwards, too. `sorted` as
// above.
DisplayRange axisAround(const DisplayRange& range, const std::vector<float>& sorted);

// How many values lie in each of `count` equal parts of the axis, the most being 1.
std::vector<float> heightsAlong(const DisplayRange& axis, const std::vector<float>& sorted,
                                int count);

}  // namespace cutis
