#pragma once

// The largest deviation that a parameter's range allows.
//
// The normal approximation of a logarithm knows nothing of the range: far out it promises more than
// there is. No distribution that is at most flat over the range [0, maximum] lies further from an
// estimate than the flat one, u = √(maximum² / 12 + (estimate − maximum / 2)²) on root mean square.
// Thread-safe: a pure function.

#include <cmath>

namespace cutis {

// (deviation⁻⁸ + u⁻⁸)^(−1/8): smooth, below u, and the deviation itself within 0.5 % up to two
// thirds of u. Preconditions: deviation finite and not negative, maximum positive.
inline double limitedDeviation(double deviation, double estimate, double maximum) {
  const double fromMiddle = estimate / maximum - 0.5;
  const double most = maximum * std::sqrt(1.0 / 12.0 + fromMiddle * fromMiddle);
  const double share = std::pow(deviation / most, 8);
  return deviation / std::pow(1.0 + share, 1.0 / 8.0);
}

}  // namespace cutis
