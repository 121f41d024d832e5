// The cube root of vectors of float. Included once per instruction set (Highway).

#if defined(CUTIS_CORE_MATHS_CUBE_ROOT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_MATHS_CUBE_ROOT_INL_H_
#undef CUTIS_CORE_MATHS_CUBE_ROOT_INL_H_
#else
#define CUTIS_CORE_MATHS_CUBE_ROOT_INL_H_
#endif

#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Takes x from 0 to 1e18 and is right to 1e-6, relative: a third of the exponent is the first
// guess, then come Halley's rounds. What is below 1e-20 counts as that.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V CubeRoot(D d, V x) {
  const hn::RebindToSigned<D> integers;
  x = hn::Max(x, hn::Set(d, 1e-20f));  // cubes of the root stay normal numbers
  const V third = hn::Mul(hn::ConvertTo(d, hn::BitCast(integers, x)), hn::Set(d, 1.0f / 3.0f));
  V root = hn::BitCast(
      d, hn::Add(hn::ConvertTo(integers, third), hn::Set(integers, std::int32_t{709921077})));
  for (int round = 0; round < 2; ++round) {
    const V cube = hn::Mul(hn::Mul(root, root), root);
    root = hn::Div(hn::Mul(root, hn::MulAdd(hn::Set(d, 2.0f), x, cube)),
                   hn::MulAdd(hn::Set(d, 2.0f), cube, x));
  }
  return root;
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
