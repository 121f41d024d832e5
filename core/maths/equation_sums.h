#pragma once

// The normal equations of N coordinates, summed up wavelength by wavelength for many parameter sets
// at once.

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace cutis {

template <int N>
struct EquationsOf {
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  Matrix hessian = Matrix::Zero();   // Jᵀ J
  Vector downhill = Vector::Zero();  // Jᵀ (measured − modelled)
  double cost = 0.0;                 // Σ (measured − modelled)²
};

// Not thread-safe; each set's sums are its own, whatever the others are.
template <int N>
class EquationSums {
 public:
  explicit EquationSums(std::size_t count)
      : count_(count), sums_(kSums * count), gradient_(N * count), residual_(count) {}

  // What the next wavelength adds, to be filled in: ∂modelled of coordinate k, and measured −
  // modelled; [set].
  double* gradient(std::size_t k) { return gradient_.data() + k * count_; }
  double* residual() { return residual_.data(); }

  // The loops over sets run in vectors.
  void add() {
    double* sum = sums_.data();
    const auto addProducts = [&](const double* a, const double* b) {
      for (std::size_t i = 0; i < count_; ++i)
        sum[i] += a[i] * b[i];
      sum += count_;
    };
    for (std::size_t j = 0; j < N; ++j) {
      for (std::size_t k = 0; k <= j; ++k)
        addProducts(gradient(j), gradient(k));
    }
    for (std::size_t k = 0; k < N; ++k)
      addProducts(gradient(k), residual());
    addProducts(residual(), residual());
  }

  std::vector<EquationsOf<N>> equations() const {
    std::vector<EquationsOf<N>> equations(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      const double* sum = sums_.data() + i;
      const auto next = [&] {
        const double value = *sum;
        sum += count_;
        return value;
      };
      EquationsOf<N>& own = equations[i];
      for (int j = 0; j < N; ++j) {
        for (int k = 0; k <= j; ++k)
          own.hessian(j, k) = own.hessian(k, j) = next();
      }
      for (int k = 0; k < N; ++k)
        own.downhill[k] = next();
      own.cost = next();
    }
    return equations;
  }

 private:
  // Sums of a set: the lower triangle of the hessian, the slopes and the cost.
  static constexpr std::size_t kSums = N * (N + 1) / 2 + N + 1;

  std::size_t count_;
  std::vector<double> sums_;  // [sum][set]
  std::vector<double> gradient_, residual_;
};

}  // namespace cutis
