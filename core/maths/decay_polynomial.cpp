#include "core/maths/decay_polynomial.h"

#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace cutis {

template <std::size_t kTerms>
std::array<double, kTerms> decayPolynomial(double rate, double end) {
  constexpr auto n = static_cast<Eigen::Index>(kTerms);
  Eigen::Matrix<double, n, n> powers;
  Eigen::Matrix<double, n, 1> values;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) + 0.5) / double{kTerms};
    const double x = 0.5 * end * (1.0 - std::cos(angle));
    for (Eigen::Index k = 0; k < n; ++k)
      powers(i, k) = std::pow(x, static_cast<double>(k));
    values[i] = std::exp(-rate * x);
  }
  const Eigen::Matrix<double, n, 1> solution = powers.fullPivLu().solve(values);
  std::array<double, kTerms> coefficients;
  for (std::size_t k = 0; k < kTerms; ++k)
    coefficients[k] = solution[static_cast<Eigen::Index>(k)];
  return coefficients;
}

template std::array<double, 6> decayPolynomial<6>(double, double);
template std::array<double, 7> decayPolynomial<7>(double, double);

}  // namespace cutis
