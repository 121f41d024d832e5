#include "core/base/half.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr std::uint16_t kInfinity = 0x7c00;

float toFloat(std::uint16_t half) {
  float value = 0.0f;
  convertHalfToFloat({&half, 1}, {&value, 1});
  return value;
}

std::uint16_t toHalf(float value) {
  std::uint16_t half = 0;
  convertFloatToHalf({&value, 1}, {&half, 1});
  return half;
}

// IEEE 754-2008, binary16: sign, 5 bits of exponent (bias 15), 10 of fraction.
double definition(std::uint16_t half) {
  const int exponent = half >> 10 & 0x1f;
  const int fraction = half & 0x3ff;
  const double sign = (half & 0x8000) != 0 ? -1.0 : 1.0;
  if (exponent == 0) return sign * std::ldexp(fraction, -24);
  return sign * std::ldexp(1024 + fraction, exponent - 25);
}

bool isNan(std::uint16_t half) {
  return (half & 0x7fff) > kInfinity;
}

class HalfTest : public QObject {
  Q_OBJECT

 private slots:
  void everyHalfIsItsDefinition() {
    for (std::uint32_t bits = 0; bits < 0x10000; ++bits) {
      const auto half = static_cast<std::uint16_t>(bits);
      const float value = toFloat(half);
      if (isNan(half)) {
        QVERIFY(std::isnan(value));
      } else if ((half & 0x7fff) == kInfinity) {
        QVERIFY(std::isinf(value));
        QCOMPARE(std::signbit(value), (half & 0x8000) != 0);
      } else {
        QCOMPARE(double{value}, definition(half));
        QCOMPARE(std::signbit(value), (half & 0x8000) != 0);
      }
    }
  }

  void everyHalfComesBack() {
    for (std::uint32_t bits = 0; bits < 0x10000; ++bits) {
      const auto half = static_cast<std::uint16_t>(bits);
      const std::uint16_t back = toHalf(toFloat(half));
      if (isNan(half)) {
        QVERIFY(isNan(back));
      } else {
        QCOMPARE(back, half);
      }
    }
  }

  // Between each two neighbours the middle goes to the even one, anything off it to the nearer.
  void everyGapRoundsToNearestEven() {
    for (std::uint16_t half = 0; half < 0x7bff; ++half) {
      const float middle = 0.5f * (toFloat(half) + toFloat(static_cast<std::uint16_t>(half + 1)));
      const auto even = static_cast<std::uint16_t>(half + (half & 1));
      QCOMPARE(toHalf(middle), even);
      QCOMPARE(toHalf(std::nextafter(middle, 0.0f)), half);
      QCOMPARE(toHalf(std::nextafter(middle, 1e9f)), static_cast<std::uint16_t>(half + 1));
      QCOMPARE(toHalf(-middle), static_cast<std::uint16_t>(even | 0x8000));
    }
  }

  void knownValues() {
    QCOMPARE(toHalf(0.0f), std::uint16_t{0});
    QCOMPARE(toHalf(-0.0f), std::uint16_t{0x8000});
    QCOMPARE(toHalf(1.0f), std::uint16_t{0x3c00});
    QCOMPARE(toHalf(-2.0f), std::uint16_t{0xc000});
    QCOMPARE(toHalf(65504.0f), std::uint16_t{0x7bff});
    QCOMPARE(toHalf(0x1p-14f), std::uint16_t{0x0400});  // smallest normal
    QCOMPARE(toHalf(0x1p-24f), std::uint16_t{0x0001});  // smallest of all
    QCOMPARE(toHalf(1.0f / 3.0f), std::uint16_t{0x3555});
  }

  void theEndsOfTheRange() {
    QCOMPARE(toHalf(std::nextafter(65520.0f, 0.0f)), std::uint16_t{0x7bff});
    QCOMPARE(toHalf(65520.0f), kInfinity);
    QCOMPARE(toHalf(-65520.0f), std::uint16_t{0xfc00});
    QCOMPARE(toHalf(std::numeric_limits<float>::max()), kInfinity);
    QCOMPARE(toHalf(std::numeric_limits<float>::infinity()), kInfinity);
    QCOMPARE(toHalf(0x1p-25f), std::uint16_t{0});  // half a step: to even
    QCOMPARE(toHalf(std::nextafter(0x1p-25f, 1.0f)), std::uint16_t{1});
    QCOMPARE(toHalf(std::numeric_limits<float>::denorm_min()), std::uint16_t{0});
  }

  void notANumberStaysOne() {
    for (const std::uint32_t bits : {0x7f800001u, 0x7fc00000u, 0x7fffffffu, 0xff800001u}) {
      const std::uint16_t half = toHalf(std::bit_cast<float>(bits));
      QVERIFY(isNan(half));
      // What a NaN carries goes to no file.
      QCOMPARE(half, static_cast<std::uint16_t>(bits >> 31 != 0 ? 0xfe00 : 0x7e00));
    }
  }

  void spansConvertElementByElement() {
    std::vector<float> values;
    for (int i = 0; i < 1000; ++i)
      values.push_back(std::sin(static_cast<float>(i)));
    std::vector<std::uint16_t> halves(values.size());
    convertFloatToHalf(values, halves);
    for (std::size_t i = 0; i < values.size(); ++i)
      QCOMPARE(halves[i], toHalf(values[i]));
    std::vector<float> back(values.size());
    convertHalfToFloat(halves, back);
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(back[i], values[i], 0x1p-12);
  }
};

CUTIS_TEST(HalfTest)

}  // namespace
}  // namespace cutis

#include "half_test.moc"
