#include "core/analyse/doubtful_value.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "core/analyse/misfit.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class DoubtfulValueTest : public QObject {
  Q_OBJECT

 private slots:
  void bounds() {
    const ParameterAxis axis = {0.5, 2, 1};
    QVERIFY(isAtBound(0.0, axis) && isAtBound(0.5, axis) && isAtBound(0.49999, axis));
    QVERIFY(!isAtBound(0.001, axis) && !isAtBound(0.499, axis));
    QVERIFY(!isAtBound(std::nan(""), axis));
  }

  void thePriorSpeaksWhereItsDeviationIsHardlyNarrowed() {
    Prior prior;
    prior.deviation[kMelanin] = 1.0;       // of the logarithm
    prior.deviation[kMelaninBlend] = 0.2;  // of the share itself
    QVERIFY(!isMostlyPrior(0.1, 0.049, prior, kMelanin));
    QVERIFY(isMostlyPrior(0.1, 0.051, prior, kMelanin));
    QVERIFY(!isMostlyPrior(0.9, 0.099, prior, kMelaninBlend));
    QVERIFY(isMostlyPrior(0.9, 0.101, prior, kMelaninBlend));
    QVERIFY(isMostlyPrior(0.9, std::nan(""), prior, kMelaninBlend));
  }

  void misfitsAreCountedInNoise() {
    PixelBuffer<float> channels(2, 2), residuals(2, 2);
    channels[0][0] = channels[1][0] = 0.4f;
    residuals[0][0] = 0.03f;
    residuals[1][0] = 0.04f;
    channels[1][1] = residuals[1][1] = std::numeric_limits<float>::quiet_NaN();
    const auto found = misfitsOf({0.01, 0.0, 0.0}, channels.rows(), residuals.rows());
    EXPECT_NEAR(found[0], std::sqrt((9.0 + 16.0) / 2.0), 1e-6);
    QVERIFY(std::isnan(found[1]));
  }

  void withoutNoiseTheRigsCounts() {
    Rig rig = test::monitorRig();
    rig.noise = {0.002, 0.01, 0.0};
    EXPECT_NEAR(misfitNoise(rig, NoiseModel{0.0, 0.0, 0.0}).proportional, 0.01, 0.0);
    EXPECT_NEAR(misfitNoise(rig, NoiseModel{0.0, 0.005, 0.0}).proportional, 0.005, 0.0);
    rig.noise = {0.0, 0.0, 0.0};
    EXPECT_NEAR(misfitNoise(rig, {}).proportional, NoiseModel{}.proportional, 0.0);
  }
};

CUTIS_TEST(DoubtfulValueTest)

}  // namespace
}  // namespace cutis

#include "doubtful_value_test.moc"
