#include "core/spectra/grid.h"

#include <cmath>

#include <QtTest>

#include "core/base/random.h"
#include "core/spectra/spectral_curve.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class GridTest : public QObject {
  Q_OBJECT

 private slots:
  // resources/manual/model.md: 300–1000 nm in 2 nm steps, 351 samples.
  void isTheOneGrid() {
    QCOMPARE(kSampleCount, 351);
    EXPECT_NEAR(wavelengthNm(0), 300.0, 0.0);
    EXPECT_NEAR(wavelengthNm(125), 550.0, 0.0);
    EXPECT_NEAR(wavelengthNm(350), 1000.0, 0.0);
  }

  void bandsIncludeBothEnds() {
    QVERIFY(bandBetween(300, 400) == kUltravioletBand);
    QVERIFY(bandBetween(400, 700) == kVisibleBand);
    QVERIFY(bandBetween(700, 1000) == kNearInfraredBand);
    QCOMPARE(kVisibleBand.count(), 151);
    QVERIFY(kVisibleBand.contains(50) && kVisibleBand.contains(200));
    QVERIFY(!kVisibleBand.contains(49) && !kVisibleBand.contains(201));
  }

  void bandsTakeTheSamplesWithin() {
    QVERIFY((bandBetween(449.9, 452.1) == Band{75, 76}));
    QVERIFY((bandBetween(450.1, 453.9) == Band{76, 76}));
    QVERIFY(bandBetween(450.1, 451.9).count() <= 0);
    QVERIFY((bandBetween(-1e9, 1e9) == Band{0, 350}));
    QVERIFY(bandBetween(1001, 2000).count() <= 0);
    QVERIFY(bandBetween(0, 299).count() <= 0);
    QVERIFY(bandBetween(600, 500).count() <= 0);
  }
};

class SpectralCurveTest : public QObject {
  Q_OBJECT

 private slots:
  void isExactOnTheGrid() {
    Random random(1);
    SpectralCurve curve;
    for (int i = 0; i < kSampleCount; ++i) {
      curve.wavelengthsNm.push_back(wavelengthNm(i));
      curve.values.push_back(random.uniform(-5.0, 5.0));
    }
    const Spectrum once = resample(curve);
    for (int i = 0; i < kSampleCount; ++i)
      QCOMPARE(once[i], curve.values[std::size_t(i)]);
    // And doing it again changes nothing.
    curve.values.assign(once.begin(), once.end());
    QVERIFY((resample(curve) == once).all());
  }

  void straightLinesStayStraight() {
    const SpectralCurve curve = {{280, 333.3, 471, 800.5, 1100}, {280, 333.3, 471, 800.5, 1100}};
    const Spectrum line = resample(curve);
    for (int i = 0; i < kSampleCount; ++i)
      EXPECT_NEAR(line[i], wavelengthNm(i), 1e-10);
  }

  void isZeroOutsideItsRange() {
    const Spectrum part = resample({{401, 451, 499}, {1, 1, 1}});
    for (int i = 0; i < kSampleCount; ++i) {
      const bool inside = wavelengthNm(i) >= 401 && wavelengthNm(i) <= 499;
      EXPECT_NEAR(part[i], inside ? 1.0 : 0.0, 1e-15);
    }
    // Both ends count.
    const Spectrum ends = resample({{400, 500}, {3, 4}});
    EXPECT_NEAR(ends[50], 3.0, 0.0);
    EXPECT_NEAR(ends[100], 4.0, 0.0);
    EXPECT_NEAR(ends[49], 0.0, 0.0);
    EXPECT_NEAR(ends[101], 0.0, 0.0);
  }

  void staysBetweenItsNeighbours() {
    Random random(9);
    SpectralCurve curve;
    double at = 290.0;
    while (at < 1010.0) {
      curve.wavelengthsNm.push_back(at);
      curve.values.push_back(random.uniform());
      at += random.uniform(0.01, 9.0);
    }
    const Spectrum fine = resample(curve);
    QVERIFY((fine >= 0.0).all() && (fine <= 1.0).all());
  }

  void oneSampleIsOneLine() {
    const Spectrum line = resample({{546}, {7}});
    EXPECT_NEAR(line[123], 7.0, 0.0);
    EXPECT_NEAR(line.sum(), 7.0, 0.0);
    EXPECT_NEAR(resample({{545}, {7}}).sum(), 0.0, 0.0);
  }
};

CUTIS_TEST(GridTest)
CUTIS_TEST(SpectralCurveTest)

}  // namespace
}  // namespace cutis

#include "grid_test.moc"
