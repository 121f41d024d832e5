#include "core/skin/profile/prior.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

Prior correlated() {
  Prior prior;
  prior.mean << 0.04, 0.4, 0.03, 0.02, 0.003;
  prior.deviation << 0.8, 0.3, 0.7, 0.6, 0.0025;
  prior.correlation(0, 4) = prior.correlation(4, 0) = -0.4;
  prior.correlation(1, 3) = prior.correlation(3, 1) = 0.35;
  prior.correlation(2, 4) = prior.correlation(4, 2) = 0.5;
  return prior;
}

class PriorTest : public QObject {
  Q_OBJECT

 private slots:
  void scalesArePerParameter() {
    Prior prior;
    for (const Parameter parameter : kParameters) {
      QCOMPARE(prior.isLog(parameter), parameter != kMelaninBlend);
    }
    prior.staysLinear[kCarotene] = true;
    QVERIFY(!prior.isLog(kCarotene) && prior.isLog(kMelanin));
    prior.scale = PriorScale::linear;
    for (const Parameter parameter : kParameters)
      QVERIFY(!prior.isLog(parameter));
  }

  void withoutCorrelationThePrecisionIsDiagonal() {
    Prior prior = correlated();
    prior.correlation.setIdentity();
    const ParameterMatrix precision = prior.precision();
    for (int i = 0; i < kParameterCount; ++i) {
      for (int j = 0; j < kParameterCount; ++j) {
        const double d = prior.deviation[i];
        EXPECT_NEAR(precision(i, j), i == j ? 1.0 / (d * d) : 0.0, 1e-14 / (d * d));
      }
    }
  }

  void precisionIsTheInverseOfTheCovariance() {
    const Prior prior = correlated();
    const ParameterMatrix precision = prior.precision();
    QVERIFY(precision == precision.transpose());
    for (int i = 0; i < kParameterCount; ++i) {
      for (int j = 0; j < kParameterCount; ++j) {
        double product = 0.0;
        for (int k = 0; k < kParameterCount; ++k) {
          product += precision(i, k) * prior.deviation[k] * prior.correlation(k, j);
        }
        EXPECT_NEAR(product * prior.deviation[i], i == j ? 1.0 : 0.0, 1e-13);
      }
    }
    // Two parameters by hand: 1 / (d² (1 − r²)) and −r / (d₁ d₂ (1 − r²)).
    const double rest = 1.0 - 0.35 * 0.35;
    EXPECT_NEAR(precision(1, 1), 1.0 / (0.3 * 0.3 * rest), 1e-12);
    EXPECT_NEAR(precision(1, 3), -0.35 / (0.3 * 0.6 * rest), 1e-12);
  }

  void impossiblePriorsAreRefused() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_OK(validate(correlated(), "p"));
    const auto refused = [](const char* part, auto change) {
      Prior prior = correlated();
      change(prior);
      EXPECT_ERROR(validate(prior, "p.json", "prior."), part);
    };
    refused("p.json: prior.mean.melanin must be positive on the log scale",
            [](Prior& p) { p.mean[kMelanin] = 0.0; });
    refused("prior.mean.carotene must be finite", [&](Prior& p) { p.mean[kCarotene] = nan; });
    refused("prior.sd.carotene must be positive", [](Prior& p) { p.deviation[kCarotene] = 0.0; });
    refused("prior.sd.melanin must be positive", [&](Prior& p) { p.deviation[kMelanin] = nan; });
    refused("prior.correlation must be finite and symmetric",
            [](Prior& p) { p.correlation(0, 1) = 0.1; });
    refused("prior.correlation must be finite and symmetric",
            [](Prior& p) { p.correlation(2, 2) = 1.1; });
    refused("prior.correlation must be finite and symmetric",
            [&](Prior& p) { p.correlation(0, 1) = p.correlation(1, 0) = nan; });
    refused("prior.correlation must be positive definite", [](Prior& p) {
      p.correlation(0, 1) = p.correlation(1, 0) = 0.9;
      p.correlation(1, 2) = p.correlation(2, 1) = 0.9;
      p.correlation(0, 2) = p.correlation(2, 0) = -0.9;
    });
    // On the linear scale a mean of 0 is a proper mean.
    Prior linear = correlated();
    linear.scale = PriorScale::linear;
    linear.mean.setZero();
    EXPECT_OK(validate(linear, "p"));
  }
};

CUTIS_TEST(PriorTest)

}  // namespace
}  // namespace cutis

#include "prior_test.moc"
