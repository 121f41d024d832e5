#include "core/rig/channel_extent.h"

#include <cmath>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// A Gaussian line of a standard deviation.
Spectrum lineAt(double nm, double deviationNm) {
  Spectrum line;
  for (int i = 0; i < kSampleCount; ++i)
    line[i] = std::exp(-0.5 * std::pow((wavelengthNm(i) - nm) / deviationNm, 2));
  return line;
}

class ChannelExtentTest : public QObject {
  Q_OBJECT

 private slots:
  void aLineLiesWhereItIsAndIsAsWide() {
    const auto extent = channelExtent(3.0 * lineAt(540, 15));
    QVERIFY(extent.has_value());
    EXPECT_NEAR(extent->effectiveNm, 540, 1e-9);
    EXPECT_NEAR(extent->deviationNm, 15, 1e-6);
  }

  void whatSeesNothingIsNowhere() {
    QVERIFY(!channelExtent(Spectrum::Zero()));
    QVERIFY(!measuredBand(SpectrumRows::Zero(3, kSampleCount)));
  }

  // All but one hundredth on either side lies within 2.326 deviations.
  void theTailsOfALineAreNotMeasured() {
    SpectrumRows rows = SpectrumRows::Zero(3, kSampleCount);
    rows.row(0) = lineAt(450, 10).transpose();
    rows.row(2) = lineAt(620, 20).transpose();
    const auto band = measuredBand(rows);
    QVERIFY(band.has_value());
    EXPECT_NEAR(wavelengthNm(band->first), 450 - 2.326 * 10, 2);
    EXPECT_NEAR(wavelengthNm(band->last), 620 + 2.326 * 20, 2);
  }

  void oneSampleIsABand() {
    SpectrumRows rows = SpectrumRows::Zero(1, kSampleCount);
    rows(0, 100) = 1.0;
    QVERIFY((measuredBand(rows) == Band{100, 100}));
  }
};

CUTIS_TEST(ChannelExtentTest)

}  // namespace
}  // namespace cutis

#include "channel_extent_test.moc"
