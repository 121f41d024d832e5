#include "core/transport/fresnel.h"

#include <cmath>

namespace cutis {

double internalReflectance(double cosineInside, double index) {
  if (index == 1.0) return 0.0;
  const double sine2 = index * index * (1.0 - cosineInside * cosineInside);
  if (sine2 >= 1.0) return 1.0;
  const double cosineInAir = std::sqrt(1.0 - sine2);
  const double across = (index * cosineInside - cosineInAir) / (index * cosineInside + cosineInAir);
  const double along = (cosineInside - index * cosineInAir) / (cosineInside + index * cosineInAir);
  return 0.5 * (across * across + along * along);
}

double normalReflectance(double index) {
  const double amplitude = (index - 1.0) / (index + 1.0);
  return amplitude * amplitude;
}

double criticalCosine(double index) {
  return std::sqrt(1.0 - 1.0 / (index * index));
}

double refractedCosine(double cosineInAir, double index) {
  return std::sqrt(1.0 - (1.0 - cosineInAir * cosineInAir) / (index * index));
}

}  // namespace cutis
