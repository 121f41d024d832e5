#pragma once

// Polynomials in place of decaying exponentials of a bounded argument: no range reduction, half the
// work.

#include <array>
#include <cstddef>

namespace cutis {

// c[0] + c[1] x + … ≈ e^(−rate · x) on [0, end]: interpolates at the Chebyshev points, which is
// within a factor of two of the best there is.
template <std::size_t kTerms>
std::array<double, kTerms> decayPolynomial(double rate, double end);

}  // namespace cutis
