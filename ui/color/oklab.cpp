#include "ui/color/oklab.h"

#include <algorithm>
#include <cmath>

namespace cutis {
namespace {

double encoded(double linear) {
  if (linear <= 0.0031308) return 12.92 * linear;
  return 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

int code(double linear) {
  return static_cast<int>(std::lround(255 * std::clamp(encoded(linear), 0.0, 1.0)));
}

double cube(double x) {
  return x * x * x;
}

}  // namespace

double distance(const OkLab& from, const OkLab& to) {
  return std::hypot(to.lightness - from.lightness, to.a - from.a, to.b - from.b);
}

QRgb toSrgb(const OkLab& c) {
  const double l = cube(c.lightness + 0.3963377774 * c.a + 0.2158037573 * c.b);
  const double m = cube(c.lightness - 0.1055613458 * c.a - 0.0638541728 * c.b);
  const double s = cube(c.lightness - 0.0894841775 * c.a - 1.2914855480 * c.b);
  return qRgb(code(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
              code(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
              code(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s));
}

}  // namespace cutis
