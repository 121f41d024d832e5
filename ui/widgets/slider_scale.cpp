#include "ui/widgets/slider_scale.h"

#include <algorithm>

namespace cutis {

// This follows from valueAt(½) = neutral and valueAt(1) = maximum.
double SliderScale::curvature() const {
  const double span = maximum - minimum;
  const double toNeutral = neutral - minimum;
  return (span - 2 * toNeutral) / (span - toNeutral);
}

double SliderScale::valueAt(double place) const {
  const double u = std::clamp(place, 0.0, 1.0);
  const double c = curvature();
  return minimum + (maximum - minimum) * (1 - c) * u / (1 - c * u);
}

double SliderScale::placeOf(double value) const {
  const double v = std::clamp(value, minimum, maximum) - minimum;
  const double c = curvature();
  return v / ((maximum - minimum) * (1 - c) + c * v);
}

}  // namespace cutis
