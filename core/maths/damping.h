#pragma once  // internal to core/maths

// The damping of Levenberg's steps: more of it where the quadratic promised too much, less where it
// kept its word.

#include <algorithm>

namespace cutis {

class Damping {
 public:
  // Never less than this: from there, fewer refusals lead to short steps.
  explicit Damping(double least) : least_(least) {}

  // The share by which the diagonal of the normal matrix grows.
  double value() const { return value_; }

  // A step lowered the cost by `gained` (≥ 0) where the quadratic promised `promised`.
  void accept(double gained, double promised) {
    value_ *= gained > 0.75 * promised ? 0.1 : gained < 0.25 * promised ? 3.0 : 1.0;
    value_ = std::max(value_, least_);
  }
  void reject() { value_ *= 10.0; }

 private:
  static constexpr double kFirst = 1e-3;

  double least_;
  double value_ = kFirst;
};

}  // namespace cutis
