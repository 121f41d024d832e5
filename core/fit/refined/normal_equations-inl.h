// The 5 × 5 normal equations of a vector of pixels. Included once per instruction set (Highway).

#if defined(CUTIS_CORE_FIT_REFINED_NORMAL_EQUATIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_FIT_REFINED_NORMAL_EQUATIONS_INL_H_
#undef CUTIS_CORE_FIT_REFINED_NORMAL_EQUATIONS_INL_H_
#else
#define CUTIS_CORE_FIT_REFINED_NORMAL_EQUATIONS_INL_H_
#endif

#include <hwy/highway.h>

#include "core/skin/profile/parameter.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// L D Lᵀ of the equations.
template <class V>
struct Factorisation {
  static constexpr int kSize = kParameterCount;
  V lower[kSize][kSize];  // below the diagonal
  V inverse[kSize];       // 1 / D

  template <class D>
  HWY_INLINE void Solve(D, const V* right, V* solution) const {
    for (int i = 0; i < kSize; ++i) {
      V sum = right[i];
      for (int k = 0; k < i; ++k)
        sum = hn::NegMulAdd(lower[i][k], solution[k], sum);
      solution[i] = sum;
    }
    for (int i = kSize - 1; i >= 0; --i) {
      V sum = hn::Mul(solution[i], inverse[i]);
      for (int k = i + 1; k < kSize; ++k)
        sum = hn::NegMulAdd(lower[k][i], solution[k], sum);
      solution[i] = sum;
    }
  }
};

template <class V>
struct NormalEquations {
  static constexpr int kSize = kParameterCount;

  V hessian[kSize][kSize];  // lower triangle
  V downhill[kSize];        // half the negative gradient of the cost
  V cost;

  template <class D>
  HWY_INLINE void Clear(D d) {
    for (int i = 0; i < kSize; ++i) {
      for (int j = 0; j <= i; ++j)
        hessian[i][j] = hn::Zero(d);
      downhill[i] = hn::Zero(d);
    }
    cost = hn::Zero(d);
  }

  // One channel: its derivatives, its residual and 1 / variance.
  template <class D>
  HWY_INLINE void Add(D, const V* row, V residual, V precision) {
    for (int i = 0; i < kSize; ++i) {
      const V weighted = hn::Mul(row[i], precision);
      for (int j = 0; j <= i; ++j)
        hessian[i][j] = hn::MulAdd(weighted, row[j], hessian[i][j]);
      downhill[i] = hn::MulAdd(weighted, residual, downhill[i]);
    }
    cost = hn::MulAdd(hn::Mul(residual, precision), residual, cost);
  }

  // Takes coordinate i out of the equations where `held`.
  template <class D, class M>
  HWY_INLINE void Hold(D d, int i, M held) {
    for (int j = 0; j < i; ++j)
      hessian[i][j] = hn::IfThenZeroElse(held, hessian[i][j]);
    for (int j = i + 1; j < kSize; ++j)
      hessian[j][i] = hn::IfThenZeroElse(held, hessian[j][i]);
    hessian[i][i] = hn::IfThenElse(held, hn::Set(d, hn::TFromD<D>(1)), hessian[i][i]);
    downhill[i] = hn::IfThenZeroElse(held, downhill[i]);
  }

  // Prescribes the step of coordinate i where `held` and leaves the others to follow.
  template <class D, class M>
  HWY_INLINE void Prescribe(D d, int i, M held, V step) {
    const V known = hn::IfThenElseZero(held, step);
    for (int j = 0; j < kSize; ++j) {
      if (j == i) continue;
      const V coupling = j < i ? hessian[i][j] : hessian[j][i];
      downhill[j] = hn::NegMulAdd(coupling, known, downhill[j]);
    }
    Hold(d, i, held);
    downhill[i] = hn::IfThenElse(held, step, downhill[i]);
  }

  // The hessian is positive definite thanks to the prior; rounding may eat a pivot that the data
  // hardly determine, so pivots are kept above a share of what they started from.
  template <class D>
  HWY_INLINE void Factorise(D d, Factorisation<V>& factor) const {
    using T = hn::TFromD<D>;
    const V floor = hn::Set(d, sizeof(T) == 4 ? T(1e-6) : T(1e-14));
    V scaled[kSize][kSize];  // L D
    for (int i = 0; i < kSize; ++i) {
      for (int j = 0; j < i; ++j) {
        V sum = hessian[i][j];
        for (int k = 0; k < j; ++k)
          sum = hn::NegMulAdd(scaled[i][k], factor.lower[j][k], sum);
        scaled[i][j] = sum;
        factor.lower[i][j] = hn::Mul(sum, factor.inverse[j]);
      }
      V pivot = hessian[i][i];
      for (int k = 0; k < i; ++k)
        pivot = hn::NegMulAdd(scaled[i][k], factor.lower[i][k], pivot);
      pivot = hn::Max(pivot, hn::Mul(hessian[i][i], floor));
      factor.inverse[i] = hn::Div(hn::Set(d, T(1)), pivot);
    }
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
