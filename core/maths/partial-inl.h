// The first few lanes of a vector, from and to memory. Included once per instruction set (Highway).

#if defined(CUTIS_CORE_MATHS_PARTIAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_MATHS_PARTIAL_INL_H_
#undef CUTIS_CORE_MATHS_PARTIAL_INL_H_
#else
#define CUTIS_CORE_MATHS_PARTIAL_INL_H_
#endif

#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// `live` numbers from any address; zero in the lanes beyond. Highway's own MaskedLoad reads whole
// aligned vectors where the instruction set has no masks.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V LoadFirst(D d, const hn::TFromD<D>* from, std::size_t live) {
  if (live == hn::Lanes(d)) return hn::LoadU(d, from);
  HWY_ALIGN hn::TFromD<D> values[hn::MaxLanes(D())] = {};
  for (std::size_t lane = 0; lane < live; ++lane)
    values[lane] = from[lane];
  return hn::Load(d, values);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void StoreFirst(D d, V value, hn::TFromD<D>* to, std::size_t live) {
  if (live == hn::Lanes(d)) {
    hn::StoreU(value, d, to);
    return;
  }
  HWY_ALIGN hn::TFromD<D> values[hn::MaxLanes(D())];
  hn::Store(value, d, values);
  for (std::size_t lane = 0; lane < live; ++lane)
    to[lane] = values[lane];
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
