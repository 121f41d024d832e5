#include "ui/view/oklab.h"

#include <algorithm>
#include <cmath>

namespace cutis {
namespace {

double encoded(double linear) {
  if (linear <= 0.0031308) return 12.92 * linear;
  return 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double decoded(int code) {
  const double value = code / 255.0;
  if (value <= 0.04045) return value / 12.92;
  return std::pow((value + 0.055) / 1.055, 2.4);
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

OkLab toOkLab(QRgb color) {
  const double r = decoded(qRed(color));
  const double g = decoded(qGreen(color));
  const double b = decoded(qBlue(color));
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

}  // namespace cutis
