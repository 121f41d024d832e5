#pragma once

// A number and its derivative with respect to one variable (forward-mode differentiation).
// Only what the layer optics need.

#include <cmath>

namespace cutis {

struct Dual {
  double value = 0.0;
  double slope = 0.0;

  Dual() = default;
  Dual(double v) : value(v) {}
  Dual(double v, double s) : value(v), slope(s) {}
};

inline Dual operator-(const Dual& a) {
  return {-a.value, -a.slope};
}
inline Dual operator+(const Dual& a, const Dual& b) {
  return {a.value + b.value, a.slope + b.slope};
}
inline Dual operator-(const Dual& a, const Dual& b) {
  return {a.value - b.value, a.slope - b.slope};
}
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.slope * b.value + a.value * b.slope};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.slope - quotient * b.slope) / b.value};
}
inline Dual exp(const Dual& a) {
  const double e = std::exp(a.value);
  return {e, e * a.slope};
}
inline Dual expm1(const Dual& a) {
  return {std::expm1(a.value), std::exp(a.value) * a.slope};
}
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return {root, 0.5 * a.slope / root};
}
inline Dual max(const Dual& a, const Dual& b) {
  return a.value < b.value ? b : a;
}

}  // namespace cutis
