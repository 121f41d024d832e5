#include "core/base/half.h"

#include <cassert>
#include <cmath>
#include <cstddef>

// The functions alone; the tables would have to be linked.
#define IMATH_HALF_NO_LOOKUP_TABLE
#include <Imath/half.h>

namespace cutis {
namespace {

// Highway's conversion is not exact where a processor has none of its own: it cuts off what it
// should round, and makes numbers of infinities.
std::uint16_t halfFromFloat(float value) {
  // Imath keeps a part of what a NaN carries; here all are one, so that files do not depend on it.
  if (std::isnan(value)) return std::signbit(value) ? 0xfe00 : 0x7e00;
  return imath_float_to_half(value);
}

}  // namespace

void convertHalfToFloat(std::span<const std::uint16_t> from, std::span<float> to) {
  assert(from.size() == to.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    to[i] = imath_half_to_float(from[i]);
}

void convertFloatToHalf(std::span<const float> from, std::span<std::uint16_t> to) {
  assert(from.size() == to.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    to[i] = halfFromFloat(from[i]);
}

}  // namespace cutis
