#include "core/spectra/measured_spectra.h"

#include <array>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

MeasuredSpectra twoLines() {
  return {{"a", "b"}, {400.0, 405.0, 420.0}, {0.1, 0.2, 0.5, 0.6, 0.5, 0.2}};
}

class MeasuredSpectraTest : public QObject {
  Q_OBJECT

 private slots:
  void rangesIncludeBothEnds() {
    const WavelengthRange range = {400.0, 700.0};
    QVERIFY(range.contains(400.0) && range.contains(700.0) && range.contains(550.5));
    QVERIFY(!range.contains(399.999) && !range.contains(700.001));
  }

  void eachSpectrumIsARow() {
    const MeasuredSpectra spectra = twoLines();
    const auto second = spectrumAt(spectra, 1);
    QCOMPARE(second.size(), std::size_t{3});
    EXPECT_NEAR(second[0], 0.6, 0.0);
    EXPECT_NEAR(second[2], 0.2, 0.0);
  }

  void theGridIsReachedByLines() {
    const Spectrum spectrum = onGrid(twoLines(), 0);
    const auto at = [&](int nm) { return spectrum[(nm - kFirstWavelengthNm) / kWavelengthStepNm]; };
    EXPECT_NEAR(at(400), 0.1, 1e-15);
    EXPECT_NEAR(at(402), 0.14, 1e-15);
    EXPECT_NEAR(at(406), 0.22, 1e-15);
    EXPECT_NEAR(at(420), 0.5, 1e-15);
    // Beyond what was measured the last lines go on.
    EXPECT_NEAR(at(390), -0.1, 1e-12);
    EXPECT_NEAR(at(430), 0.7, 1e-12);
  }

  void someAreSelectedInOrder() {
    const std::array<std::size_t, 3> order = {1, 0, 1};
    const MeasuredSpectra some = selected(twoLines(), order);
    QVERIFY((some.ids == std::vector<std::string>{"b", "a", "b"}));
    QCOMPARE(some.reflectances.size(), std::size_t{9});
    EXPECT_NEAR(some.reflectances[0], 0.6, 0.0);
    EXPECT_NEAR(some.reflectances[3], 0.1, 0.0);
    EXPECT_NEAR(some.reflectances[8], 0.2, 0.0);
    QVERIFY(some.wavelengthsNm == twoLines().wavelengthsNm);
  }
};

CUTIS_TEST(MeasuredSpectraTest)

}  // namespace
}  // namespace cutis

#include "measured_spectra_test.moc"
