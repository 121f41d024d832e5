// The 5 × 5 normal equations of a vector of pixels. Included once per instruction set (Highway).

#if defined(CUTIS_CORE_FIT_NORMAL_EQUATIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_FIT_NORMAL_EQUATIONS_INL_H_
#undef CUTIS_CORE_FIT_NORMAL_EQUATIONS_INL_H_
#else
#define CUTIS_CORE_FIT_NORMAL_EQUATIONS_INL_H_
#endif

#include <hwy/highway.h>

#include "core/skin/parameter.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct NormalEquations {
  static constexpr int kSize = kParameterCount;

  V hessian[kSize][kSize];  // lower triangle
  V downhill[kSize];        // half the negative gradient of the cost
  V cost;

  template <class D>
  HWY_INLINE void Clear(D d) {
    for (int i = 0; i < kSize; ++i) {
      for (int j = 0; j <= i; ++j) hessian[i][j] = hn::Zero(d);
      downhill[i] = hn::Zero(d);
    }
    cost = hn::Zero(d);
  }

  // One channel: its derivatives, its residual and 1 / variance.
  template <class D>
  HWY_INLINE void Add(D, const V* row, V residual, V precision) {
    for (int i = 0; i < kSize; ++i) {
      const V weighted = hn::Mul(row[i], precision);
      for (int j = 0; j <= i; ++j) hessian[i][j] = hn::MulAdd(weighted, row[j], hessian[i][j]);
      downhill[i] = hn::MulAdd(weighted, residual, downhill[i]);
    }
    cost = hn::MulAdd(hn::Mul(residual, precision), residual, cost);
  }

  template <class D>
  HWY_INLINE void AddPrior(D, int i, V towardsMean, V precision) {
    const V pull = hn::Mul(towardsMean, precision);
    hessian[i][i] = hn::Add(hessian[i][i], precision);
    downhill[i] = hn::Add(downhill[i], pull);
    cost = hn::MulAdd(pull, towardsMean, cost);
  }

  // Takes coordinate i out of the equations where `held`.
  template <class D, class M>
  HWY_INLINE void Hold(D d, int i, M held) {
    for (int j = 0; j < i; ++j) hessian[i][j] = hn::IfThenZeroElse(held, hessian[i][j]);
    for (int j = i + 1; j < kSize; ++j) hessian[j][i] = hn::IfThenZeroElse(held, hessian[j][i]);
    hessian[i][i] = hn::IfThenElse(held, hn::Set(d, hn::TFromD<D>(1)), hessian[i][i]);
    downhill[i] = hn::IfThenZeroElse(held, downhill[i]);
  }

  // step = hessian⁻¹ · downhill by L D Lᵀ; the hessian is positive definite thanks to the prior.
  template <class D>
  HWY_INLINE void Solve(D d, V* step) const {
    V lower[kSize][kSize];    // L
    V scaled[kSize][kSize];   // L D
    V inverse[kSize];         // 1 / D
    for (int i = 0; i < kSize; ++i) {
      for (int j = 0; j < i; ++j) {
        V sum = hessian[i][j];
        for (int k = 0; k < j; ++k) sum = hn::NegMulAdd(scaled[i][k], lower[j][k], sum);
        scaled[i][j] = sum;
        lower[i][j] = hn::Mul(sum, inverse[j]);
      }
      V pivot = hessian[i][i];
      for (int k = 0; k < i; ++k) pivot = hn::NegMulAdd(scaled[i][k], lower[i][k], pivot);
      // Rounding may eat a pivot that the data hardly determine.
      pivot = hn::Max(pivot, hn::Mul(hessian[i][i], hn::Set(d, Epsilon<hn::TFromD<D>>())));
      inverse[i] = hn::Div(hn::Set(d, hn::TFromD<D>(1)), pivot);
    }
    for (int i = 0; i < kSize; ++i) {
      V sum = downhill[i];
      for (int k = 0; k < i; ++k) sum = hn::NegMulAdd(lower[i][k], step[k], sum);
      step[i] = sum;
    }
    for (int i = kSize - 1; i >= 0; --i) {
      V sum = hn::Mul(step[i], inverse[i]);
      for (int k = i + 1; k < kSize; ++k) sum = hn::NegMulAdd(lower[k][i], step[k], sum);
      step[i] = sum;
    }
  }

 private:
  template <typename T>
  static constexpr T Epsilon() {
    return sizeof(T) == 4 ? static_cast<T>(1e-6) : static_cast<T>(1e-14);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
