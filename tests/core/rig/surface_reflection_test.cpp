// Channels with the reflection of the surface in them, made from channels without.

#include "core/rig/surface_reflection.h"

#include <cmath>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr int kWidth = 300, kHeight = 3;  // more than a tile across

class SurfaceReflectionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatWasAddedIsTakenOff() {
    const MeasurementGeometry geometry =
        measurementGeometry(SpecularPart::included, 1.4, kSkinSpecularShare);
    Measurements measurements = measured(
        [&](int x) { return static_cast<float>(measuredReflectance(geometry, 0.003 * x)); });
    EXPECT_OK(removeSurfaceReflection(geometry, nullptr, {}, measurements));
    for (int x = 0; x < kWidth; ++x)
      EXPECT_NEAR(valueAt(measurements, x), 0.003 * x, 1e-6);
  }

  // Darker than the reflection alone: nothing is left, and nothing below.
  void darkPixelsBecomeBlack() {
    const MeasurementGeometry geometry = measurementGeometry(SpecularPart::included, 1.4, 0.3);
    Measurements measurements = measured([](int) { return 0.1f; });
    EXPECT_OK(removeSurfaceReflection(geometry, nullptr, {}, measurements));
    QCOMPARE(valueAt(measurements, 5), 0.0f);
  }

  void nanStays() {
    const MeasurementGeometry geometry = measurementGeometry(SpecularPart::included, 1.4);
    Measurements measurements = measured([](int) { return std::nanf(""); });
    EXPECT_OK(removeSurfaceReflection(geometry, nullptr, {}, measurements));
    QVERIFY(std::isnan(valueAt(measurements, 0)));
  }

  void withoutReflectionNothingChanges() {
    Measurements measurements = measured([](int x) { return 0.003f * static_cast<float>(x); });
    EXPECT_OK(removeSurfaceReflection({}, nullptr, {}, measurements));
    for (int x = 0; x < kWidth; ++x)
      QCOMPARE(valueAt(measurements, x), 0.003f * static_cast<float>(x));
    QCOMPARE(measurements.rig.noise.veil, 0.0);
  }

  // The deviation of what is left is that of what was measured, over the share that enters.
  void noiseIsThatOfTheMeasurement() {
    const MeasurementGeometry geometry = measurementGeometry(SpecularPart::included, 1.4, 0.05);
    const NoiseModel noise = {0.001, 0.01};
    const NoiseModel below = noiseBelowSurface(noise, geometry);
    for (const double channel : {0.0, 0.1, 0.9}) {
      const double whole = std::sqrt(noise.variance(measuredReflectance(geometry, channel)));
      EXPECT_NEAR(std::sqrt(below.variance(channel)), whole / geometry.enteringShare, 1e-12);
    }
    QVERIFY(noiseBelowSurface({0.0, 0.0}, geometry).isExact());
  }

 private:
  template <typename Value>
  static Measurements measured(const Value& value) {
    Measurements measurements;
    measurements.rig = albedoRig();
    measurements.state = Plane(kWidth, kHeight, PixelFormat::float32, nullptr);
    std::vector<float> values;
    for (int i = 0; i < kWidth * kHeight; ++i)
      values.push_back(value(i % kWidth));
    for (int k = 0; k < measurements.rig.channelCount(); ++k) {
      measurements.channels.emplace_back(kWidth, kHeight, PixelFormat::float32, nullptr);
      static_cast<void>(measurements.channels.back().store(measurements.state.bounds(), values));
    }
    return measurements;
  }

  static float valueAt(const Measurements& measurements, int x) {
    std::vector<float> value(1);
    for (const Plane& channel : measurements.channels) {
      if (!channel.load({x, 1, x + 1, 2}, value)) return -1.0f;
    }
    return value[0];
  }
};

CUTIS_TEST(SurfaceReflectionTest)

}  // namespace
}  // namespace cutis::test

#include "surface_reflection_test.moc"
