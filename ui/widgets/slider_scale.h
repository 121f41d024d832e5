#pragma once

// A scale whose neutral value lies in the middle of the slider although it is nowhere near the
// middle of the range: value = a·u / (1 − c·u) above the minimum, with u the place on the slider.
// Smooth across the neutral value, and it reaches zero, which a logarithm does not.

namespace cutis {

struct SliderScale {
  // minimum < neutral < maximum, in the unit of the value.
  double minimum = 0;
  double neutral = 1;
  double maximum = 3;

  // 0 at the minimum, ½ at the neutral value, 1 at the maximum; both ways clamp.
  double placeOf(double value) const;
  double valueAt(double place) const;

 private:
  double curvature() const;
};

}  // namespace cutis
