// Evaluates core/fit/refined/start_polynomial.h for a vector of pixels. Included once per
// instruction set (Highway).

#if defined(CUTIS_CORE_FIT_REFINED_START_POLYNOMIAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_FIT_REFINED_START_POLYNOMIAL_INL_H_
#undef CUTIS_CORE_FIT_REFINED_START_POLYNOMIAL_INL_H_
#else
#define CUTIS_CORE_FIT_REFINED_START_POLYNOMIAL_INL_H_
#endif

#include <hwy/highway.h>

#include "core/fit/refined/refined_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// ln x for x ≥ 1e-4 to about 1e-5: enough for a place to begin.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V RoughLog(D d, V x) {
  using T = hn::TFromD<D>;
  constexpr int mantissaBits = sizeof(T) == 4 ? 23 : 52;
  const hn::RebindToSigned<D> di;
  // x = 2^n · m with m in [√½, √2): take away half an octave before the exponent is cut off.
  const auto root = hn::BitCast(di, hn::Set(d, T(0.70710678)));
  const auto bits = hn::Sub(hn::BitCast(di, x), root);
  const auto exponent = hn::ShiftRight<mantissaBits>(bits);
  const V n = hn::ConvertTo(d, exponent);
  const V m = hn::BitCast(d, hn::Sub(hn::BitCast(di, x), hn::ShiftLeft<mantissaBits>(exponent)));
  // atanh series in z = (m − 1)/(m + 1), |z| ≤ 0.172.
  const V z = hn::Div(hn::Sub(m, hn::Set(d, T(1))), hn::Add(m, hn::Set(d, T(1))));
  const V z2 = hn::Mul(z, z);
  V series = hn::MulAdd(z2, hn::Set(d, T(0.4)), hn::Set(d, T(2.0 / 3.0)));
  series = hn::MulAdd(z2, series, hn::Set(d, T(2)));
  return hn::MulAdd(n, hn::Set(d, T(0.69314718)), hn::Mul(z, series));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void StartPoint(D d, const StartPolynomial& polynomial, std::size_t channelCount,
                           const V* channels, V* coordinates) {
  using T = hn::TFromD<D>;
  V component[kStartComponents];
  for (int c = 0; c < kStartComponents; ++c) {
    component[c] = hn::Set(d, static_cast<T>(polynomial.offset[c]));
  }
  for (std::size_t k = 0; k < channelCount; ++k) {
    const V log = RoughLog(d, hn::Max(channels[k], hn::Set(d, T(1e-4))));
    for (int c = 0; c < kStartComponents; ++c) {
      component[c] =
          hn::MulAdd(log, hn::Set(d, static_cast<T>(polynomial.projection[c][k])), component[c]);
    }
  }
  // Far outside what the polynomial has seen it would run away.
  for (V& value : component) {
    value = hn::Min(hn::Max(value, hn::Set(d, T(-4))), hn::Set(d, T(4)));
  }
  const auto isFirst = hn::Lt(component[0], hn::Zero(d));
  const auto coefficient = [&](int i, int term) HWY_ATTR {
    return hn::IfThenElse(isFirst, hn::Set(d, static_cast<T>(polynomial.coefficients[0][i][term])),
                          hn::Set(d, static_cast<T>(polynomial.coefficients[1][i][term])));
  };
  for (int i = 0; i < kParameterCount; ++i)
    coordinates[i] = coefficient(i, 0);
  int term = 1;
  const auto add = [&](V value) HWY_ATTR {
    for (int i = 0; i < kParameterCount; ++i) {
      coordinates[i] = hn::MulAdd(value, coefficient(i, term), coordinates[i]);
    }
    ++term;
  };
  // The order of startTerms() in core/fit/refined/start_polynomial.cpp.
  for (int a = 0; a < kStartComponents; ++a) {
    add(component[a]);
    for (int b = a; b < kStartComponents; ++b) {
      const V square = hn::Mul(component[a], component[b]);
      add(square);
      for (int c = b; c < kStartComponents; ++c) {
        const V cube = hn::Mul(square, component[c]);
        add(cube);
        for (int e = c; e < kStartComponents; ++e)
          add(hn::Mul(cube, component[e]));
      }
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
