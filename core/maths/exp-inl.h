// e^x for vectors of float or double, x ≤ 80, meant for x ≤ 0. Included once per instruction set
// (Highway).
//
// Relative error 1.2e-7 in float, 3e-16 in double. Arguments below −36 are taken as −36 (2e-16):
// nothing that is subtracted from 1 can tell, and products of two results stay normal numbers.

#if defined(CUTIS_CORE_MATHS_EXP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_MATHS_EXP_INL_H_
#undef CUTIS_CORE_MATHS_EXP_INL_H_
#else
#define CUTIS_CORE_MATHS_EXP_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// (e^r − 1 − r) / r² on |r| ≤ ½ ln 2: a minimax fit for float, Taylor's series for double.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V ExpTail(D d, V r) {
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    // Terms are added in pairs (Estrin), for the latency.
    const V r2 = hn::Mul(r, r);
    const V low = hn::MulAdd(r, hn::Set(d, 1.6666521e-1f), hn::Set(d, 4.9999993e-1f));
    const V high = hn::MulAdd(r, hn::Set(d, 8.3687170e-3f), hn::Set(d, 4.1668388e-2f));
    return hn::MulAdd(r2, hn::MulAdd(r2, hn::Set(d, 1.3814599e-3f), high), low);
  } else {
    constexpr double inverseFactorials[] = {
        1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320,
        1.0 / 5040,       1.0 / 720,       1.0 / 120,      1.0 / 24,      1.0 / 6,      1.0 / 2};
    V p = hn::Zero(d);
    for (const double coefficient : inverseFactorials)
      p = hn::MulAdd(p, r, hn::Set(d, coefficient));
    return p;
  }
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V ExpOfNegative(D d, V x) {
  using T = hn::TFromD<D>;
  constexpr bool isFloat = sizeof(T) == 4;
  constexpr int mantissaBits = isFloat ? 23 : 52;
  // Adding 1.5 · 2^mantissaBits rounds to an integer n and leaves n in the last bits.
  constexpr T rounder = isFloat ? static_cast<T>(12582912.0) : static_cast<T>(6755399441055744.0);
  constexpr T ln2High = isFloat ? static_cast<T>(0.693359375) : static_cast<T>(0x1.62e42feep-1);
  constexpr T ln2Low =
      isFloat ? static_cast<T>(-2.12194440e-4) : static_cast<T>(0x1.a39ef35793c76p-33);
  const hn::RebindToUnsigned<D> bits;

  x = hn::Max(x, hn::Set(d, static_cast<T>(-36.0)));
  const V shifted =
      hn::MulAdd(x, hn::Set(d, static_cast<T>(1.4426950408889634)), hn::Set(d, rounder));
  const V n = hn::Sub(shifted, hn::Set(d, rounder));
  V r = hn::NegMulAdd(n, hn::Set(d, ln2High), x);
  r = hn::NegMulAdd(n, hn::Set(d, ln2Low), r);
  const V power =
      hn::MulAdd(hn::Mul(r, r), ExpTail(d, r), hn::Add(r, hn::Set(d, static_cast<T>(1.0))));
  // n goes straight to the exponent; the rounder's own bits are shifted out.
  const auto exponent = hn::ShiftLeft<mantissaBits>(hn::BitCast(bits, shifted));
  return hn::BitCast(d, hn::Add(hn::BitCast(bits, power), exponent));
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
