// Channels with correlated noise, made uncorrelated: what the discrepancy of the profile adds to
// the noise of a pixel. Included once per instruction set (Highway).

#if defined(CUTIS_CORE_FIT_REFINED_WHITENING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_FIT_REFINED_WHITENING_INL_H_
#undef CUTIS_CORE_FIT_REFINED_WHITENING_INL_H_
#else
#define CUTIS_CORE_FIT_REFINED_WHITENING_INL_H_
#endif

#include <hwy/highway.h>

#include "core/fit/refined/linearise-inl.h"
#include "core/fit/refined/refined_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// L of Σ = L Lᵀ, the covariance of a pixel's channels at given parameters:
//   Σ = diag(variance of the noise) + (y yᵀ) ∘ C.
// A dense factor costs no more than an update of low rank would, and does not cancel.
template <class V>
struct Whitening {
  V lower[kMaximumFitChannels * (kMaximumFitChannels + 1) / 2];  // rows; 1 / L on the diagonal

  static constexpr std::size_t At(std::size_t row, std::size_t column) {
    return row * (row + 1) / 2 + column;
  }

  template <class D, class T = hn::TFromD<D>>
  HWY_INLINE void Factorise(D d, const RefinedProblem<T>& problem, const V* measured) {
    const V one = hn::Set(d, T(1));
    for (std::size_t k = 0; k < problem.channelCount; ++k) {
      const V noise = ChannelVariance(d, problem, measured[k]);
      for (std::size_t j = 0; j <= k; ++j) {
        const V shared = hn::Mul(measured[j], hn::Set(d, problem.channelCovariance[At(k, j)]));
        V sum = j == k ? hn::MulAdd(measured[k], shared, noise) : hn::Mul(measured[k], shared);
        for (std::size_t i = 0; i < j; ++i)
          sum = hn::NegMulAdd(lower[At(k, i)], lower[At(j, i)], sum);
        // Rounding takes from a pivot at most what the noise alone would leave of it.
        lower[At(k, j)] =
            j == k ? hn::Div(one, hn::Sqrt(hn::Max(sum, noise))) : hn::Mul(sum, lower[At(j, j)]);
      }
    }
  }

  // L⁻¹ of kColumns quantities per channel, in place.
  template <std::size_t kColumns, class D, class T = hn::TFromD<D>>
  HWY_INLINE void Apply(D, const RefinedProblem<T>& problem, V (*channels)[kColumns]) const {
    for (std::size_t k = 0; k < problem.channelCount; ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        const V factor = lower[At(k, j)];
        for (std::size_t c = 0; c < kColumns; ++c)
          channels[k][c] = hn::NegMulAdd(factor, channels[j][c], channels[k][c]);
      }
      for (std::size_t c = 0; c < kColumns; ++c)
        channels[k][c] = hn::Mul(channels[k][c], lower[At(k, k)]);
    }
  }

  // L⁻ᵀ of a value per channel, in place.
  template <class D, class T = hn::TFromD<D>>
  HWY_INLINE void ApplyTransposed(D, const RefinedProblem<T>& problem, V (*channels)[1]) const {
    for (std::size_t k = problem.channelCount; k-- > 0;) {
      for (std::size_t j = k + 1; j < problem.channelCount; ++j)
        channels[k][0] = hn::NegMulAdd(lower[At(j, k)], channels[j][0], channels[k][0]);
      channels[k][0] = hn::Mul(channels[k][0], lower[At(k, k)]);
    }
  }
};

// The whitened channels of pixels, whose precision is 1.
template <class D, class V = hn::Vec<D>, class T = hn::TFromD<D>>
HWY_INLINE void WhitenMeasured(D d, const RefinedProblem<T>& problem, const V* measured,
                               V* precision, V* channels, Whitening<V>& whitening) {
  whitening.Factorise(d, problem, measured);
  V column[kMaximumFitChannels][1];
  for (std::size_t k = 0; k < problem.channelCount; ++k)
    column[k][0] = measured[k];
  whitening.Apply(d, problem, column);
  for (std::size_t k = 0; k < problem.channelCount; ++k) {
    channels[k] = column[k][0];
    precision[k] = hn::Set(d, T(1));
  }
}

// Adds what the discrepancy is expected to be at the coordinates to modelled channels and, where
// there are more columns, to their derivatives.
template <std::size_t kColumns, class D, class V = hn::Vec<D>, class T = hn::TFromD<D>>
HWY_INLINE void AddExpectedDiscrepancy(D d, const RefinedProblem<T>& problem, const V* measured,
                                       const V* coordinates, V (*channels)[kColumns]) {
  for (std::size_t k = 0; k < problem.channelCount; ++k) {
    V share = hn::Set(d, problem.channelOffset[k]);
    for (std::size_t i = 0; i < kParameterCount; ++i) {
      const V slope = hn::Set(d, problem.channelSlope[k][i]);
      share = hn::MulAdd(slope, coordinates[i], share);
      if constexpr (kColumns > 1)
        channels[k][1 + i] = hn::MulAdd(measured[k], slope, channels[k][1 + i]);
    }
    channels[k][0] = hn::MulAdd(measured[k], share, channels[k][0]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
