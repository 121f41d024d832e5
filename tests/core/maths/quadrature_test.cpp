#include "core/maths/quadrature.h"

#include <cmath>

#include <QtTest>

#include "core/transport/fresnel.h"
#include "core/transport/streams.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

double integralOfPower(const Quadrature& rule, int power) {
  return (rule.weights * rule.nodes.pow(power)).sum();
}

// Diffuse reflectance of a smooth surface seen from air, in closed form (Walsh 1926; Duntley 1942).
double walsh(double n) {
  const double n2 = n * n, n4 = n2 * n2;
  return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
         n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
         2 * n * n2 * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
         8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
}

class QuadratureTest : public QObject {
  Q_OBJECT

 private slots:
  void gaussIntegratesPolynomialsExactly() {
    for (const int points : {1, 2, 8, 16}) {
      const Quadrature rule = gaussQuadrature(points, 0.0, 1.0);
      for (int power = 0; power <= 2 * points - 1; ++power) {
        EXPECT_NEAR(integralOfPower(rule, power), 1.0 / (power + 1), 1e-14);
      }
    }
  }

  void radauIntegratesPolynomialsExactlyAndEndsAtTheEnd() {
    for (const int points : {1, 2, 8, 16}) {
      const Quadrature rule = radauQuadrature(points, 0.0, 1.0);
      QCOMPARE(rule.nodes[points - 1], 1.0);
      for (int power = 0; power <= 2 * points - 2; ++power) {
        EXPECT_NEAR(integralOfPower(rule, power), 1.0 / (power + 1), 1e-14);
      }
    }
  }

  void fresnelHasItsLimits() {
    EXPECT_NEAR(normalReflectance(1.4), 1.0 / 36.0, 1e-15);
    EXPECT_NEAR(internalReflectance(1.0, 1.4), 1.0 / 36.0, 1e-15);
    EXPECT_NEAR(internalReflectance(criticalCosine(1.4), 1.4), 1.0, 1e-6);
    EXPECT_NEAR(internalReflectance(0.1, 1.4), 1.0, 0.0);
    EXPECT_NEAR(internalReflectance(0.1, 1.0), 0.0, 0.0);
    EXPECT_NEAR(refractedCosine(0.0, 1.4), criticalCosine(1.4), 1e-15);
  }

  // η² times the diffuse flux that gets through from inside is what gets through from air.
  void streamsSeeTheSurfaceOfClosedForm() {
    for (const double index : {1.33, 1.4, 1.5}) {
      const Streams<16> streams = makeStreams<16>(index);
      EXPECT_NEAR(streams.weight.sum(), 1.0, 1e-14);
      EXPECT_NEAR(streams.fluxRoot.squaredNorm(), 1.0, 1e-8);
      const double through =
          (streams.fluxRoot.array().square() * (1.0 - streams.reflectance.array())).sum();
      EXPECT_NEAR(1.0 - index * index * through, walsh(index), 1e-6);
    }
  }

  void halfOfTheStreamsAreTrapped() {
    const Streams<16> streams = makeStreams<16>(1.4);
    for (int i = 0; i < 16; ++i) {
      QCOMPARE(streams.cosine[i] < criticalCosine(1.4), i < 8);
      QCOMPARE(streams.reflectance[i] == 1.0, i < 8);
    }
    QCOMPARE(streams.cosine[15], 1.0);
  }
};

CUTIS_TEST(QuadratureTest)

}  // namespace
}  // namespace cutis

#include "quadrature_test.moc"
