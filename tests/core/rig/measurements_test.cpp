#include "core/rig/measurements.h"

#include <vector>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class MeasurementsTest : public QObject {
  Q_OBJECT

  static Measurements twoPixels(double exposure) {
    Measurements measurements;
    measurements.channels = {Plane(2, 1), Plane(2, 1)};
    measurements.state = Plane(2, 1, PixelFormat::half);
    measurements.exposure = exposure;
    static_cast<void>(measurements.channels[1].store({0, 0, 2, 1}, std::vector{0.3f, 0.7f}));
    return measurements;
  }

  static std::vector<float> loaded(const Measurements& measurements) {
    std::vector<float> values(2);
    if (measurements.loadChannel(1, {0, 0, 2, 1}, values).failed()) return {};
    return values;
  }

 private slots:
  void withoutAnExposureChannelsAreWhatWasRead() {
    QVERIFY(loaded(twoPixels(1.0)) == (std::vector{0.3f, 0.7f}));
  }

  // What is stored stays: another exposure needs no file.
  void theExposureIsAFactorOnWhatIsLoaded() {
    Measurements measurements = twoPixels(0.5);
    QVERIFY(loaded(measurements) == (std::vector{0.5f * 0.3f, 0.5f * 0.7f}));
    measurements.exposure = 1.7;
    QVERIFY(loaded(measurements) == (std::vector{1.7f * 0.3f, 1.7f * 0.7f}));
  }
};

CUTIS_TEST(MeasurementsTest)

}  // namespace
}  // namespace cutis

#include "measurements_test.moc"
