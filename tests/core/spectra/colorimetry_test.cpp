#include "core/spectra/colorimetry.h"

#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// White points of CIE 15 at 1 nm, which the literature computes with.
const Vector3d kD65 = {0.95047, 1.0, 1.08883};
const Vector3d kA = {1.09850, 1.0, 0.35585};

Vector3d chromaticity(const Vector3d& xyz) {
  return xyz / xyz.sum();
}

class ColorimetryTest : public QObject {
  Q_OBJECT

 private slots:
  // CIE 15:2018: x, y of illuminants under the 2° observer. Fluorescent lamps are tabulated in
  // steps of 5 nm, wider than their lines; interpolating them to our grid moves them a little.
  void whitePointsOfTheIlluminants_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("tolerance");
    QTest::newRow("D65") << "D65" << 0.31272 << 0.32903 << 3e-4;
    QTest::newRow("D50") << "D50" << 0.34567 << 0.35851 << 3e-4;
    QTest::newRow("D55") << "D55" << 0.33243 << 0.34744 << 3e-4;
    QTest::newRow("A") << "A" << 0.44758 << 0.40745 << 3e-4;
    QTest::newRow("E") << "E" << 1.0 / 3.0 << 1.0 / 3.0 << 3e-4;
    QTest::newRow("FL2") << "FL2" << 0.3721 << 0.3751 << 1e-3;
    QTest::newRow("FL11") << "FL11" << 0.3805 << 0.3769 << 1e-3;
    QTest::newRow("LED_B3") << "LED_B3" << 0.3756 << 0.3723 << 3e-4;
  }
  void whitePointsOfTheIlluminants() {
    QFETCH(QString, name);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, tolerance);
    const Vector3d white = whitePoint(test::light(name.toStdString()), test::cie1931());
    EXPECT_NEAR(white[1], 1.0, 0.0);
    EXPECT_NEAR(chromaticity(white)[0], x, tolerance);
    EXPECT_NEAR(chromaticity(white)[1], y, tolerance);
  }

  void rowsGiveTheWhiteToAPerfectDiffuser() {
    for (const char* name : {"D65", "A", "FL2", "LED_B3", "iset_LCD_Gechic"}) {
      const Spectrum light = test::light(name);
      const SpectrumRows rows = tristimulusRows(light, test::cie1931());
      const Vector3d xyz = rows.matrix() * Eigen::VectorXd::Ones(kSampleCount);
      QVERIFY((xyz - whitePoint(light, test::cie1931())).norm() < 1e-14);
      // The scale of the light does not matter.
      const SpectrumRows brighter = tristimulusRows(37.0 * light, test::cie1931());
      QVERIFY((brighter - rows).abs().maxCoeff() < 1e-15);
    }
  }

  void channelsReadOneForAPerfectDiffuserAndNothingForNoLight() {
    Sensor camera = test::cie1931();
    camera.sensitivity.row(2).setZero();
    const SpectrumRows rows = channelRows(test::light("D65"), camera);
    EXPECT_NEAR(rows.row(0).sum(), 1.0, 1e-14);
    EXPECT_NEAR(rows.row(1).sum(), 1.0, 1e-14);
    QVERIFY((rows.row(2) == 0.0).all());
  }

  // The tail of a light far from what the camera sees is no measurement.
  void channelsOutOfSightSeeNothing() {
    const auto narrow = [](double middleNm) {
      Spectrum light;
      for (int i = 0; i < kSampleCount; ++i) {
        const double away = (kFirstWavelengthNm + i * kWavelengthStepNm - middleNm) / 12.0;
        light[i] = std::exp(-away * away);
      }
      return light;
    };
    QVERIFY((channelRows(narrow(960.0), test::cie1931()) == 0.0).all());
    EXPECT_NEAR(channelRows(narrow(650.0), test::cie1931()).row(0).sum(), 1.0, 1e-14);
  }

  // IEC 61966-2-1:1999, annex F.
  void rec709IsTheStandardMatrix() {
    Matrix3d published;
    published << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
    const Matrix3d matrix = xyzFromRec709(test::daylightWhite());
    EXPECT_AT_MOST((matrix - published).cwiseAbs().maxCoeff(), 2e-4);
    const Vector3d white = matrix * Vector3d::Ones();
    QVERIFY((white - test::daylightWhite()).norm() < 1e-14);
  }

  // B. Lindbloom, colour calculator: sRGB primaries under D65.
  void labOfKnownColours() {
    const Matrix3d matrix = xyzFromRec709(kD65);
    const auto lab = [&](double r, double g, double b) {
      return labFromXyz(matrix * Vector3d(r, g, b), kD65);
    };
    QVERIFY((lab(1, 0, 0) - Vector3d(53.2408, 80.0925, 67.2032)).norm() < 0.02);
    QVERIFY((lab(0, 1, 0) - Vector3d(87.7347, -86.1827, 83.1793)).norm() < 0.02);
    QVERIFY((lab(0, 0, 1) - Vector3d(32.2970, 79.1875, -107.8602)).norm() < 0.02);
    QVERIFY((lab(1, 1, 1) - Vector3d(100, 0, 0)).norm() < 1e-12);
    QVERIFY(lab(0, 0, 0).norm() < 1e-12);
  }

  // CIE 15: Y = 18.42 is L* 50; both branches meet with one slope at (6/29)³.
  void lightnessHasTwoBranchesThatMeet() {
    EXPECT_NEAR(lightness(0.184186518512), 50.0, 1e-9);
    EXPECT_NEAR(lightness(1.0), 100.0, 1e-12);
    EXPECT_NEAR(lightness(0.0), 0.0, 1e-12);
    EXPECT_NEAR(lightness(0.005), 0.005 * 24389.0 / 27.0, 1e-12);
    const double joint = 216.0 / 24389.0;
    EXPECT_NEAR(lightness(joint), 8.0, 1e-12);
    EXPECT_NEAR(lightness(std::nextafter(joint, 1.0)), 8.0, 1e-12);
    const double below = (lightness(joint) - lightness(joint - 1e-7)) / 1e-7;
    const double above = (lightness(joint + 1e-7) - lightness(joint)) / 1e-7;
    EXPECT_NEAR(below / above, 1.0, 1e-4);
    EXPECT_NEAR(lightness(-0.01), -0.01 * 24389.0 / 27.0, 1e-12);  // noise around black
  }

  // B. Lindbloom, chromatic adaptation: Bradford, D65 to A.
  void bradfordIsThePublishedMatrix() {
    Matrix3d published;
    published << 1.2164557, 0.1109905, -0.1549325, 0.1533326, 0.9152313, -0.0559953, -0.0239469,
        0.0358984, 0.3147529;
    const Matrix3d matrix = adaptationMatrix(ChromaticAdaptation::bradford, kD65, kA);
    EXPECT_AT_MOST((matrix - published).cwiseAbs().maxCoeff(), 2e-6);
  }

  void adaptationMapsWhiteToWhiteAndBack() {
    for (const auto transform : {ChromaticAdaptation::bradford, ChromaticAdaptation::cat16}) {
      const Matrix3d there = adaptationMatrix(transform, kD65, kA);
      const Matrix3d back = adaptationMatrix(transform, kA, kD65);
      QVERIFY((there * kD65 - kA).norm() < 1e-12);
      QVERIFY((back * there - Matrix3d::Identity()).norm() < 1e-12);
      QVERIFY((adaptationMatrix(transform, kA, kA) - Matrix3d::Identity()).norm() < 1e-12);
    }
    QVERIFY(adaptationMatrix(ChromaticAdaptation::none, kD65, kA) == Matrix3d::Identity());
  }

  // IEC 61966-2-1: 0.5 linear is 188 of 255.
  void srgbCurve() {
    EXPECT_NEAR(encodeSrgb(0.5), 0.7353569830524495, 1e-12);
    EXPECT_NEAR(decodeSrgb(0.5), 0.21404114048223255, 1e-12);
    EXPECT_NEAR(encodeSrgb(0.18), 0.46135612950044164, 1e-12);
    EXPECT_NEAR(encodeSrgb(0.0), 0.0, 0.0);
    EXPECT_NEAR(encodeSrgb(1.0), 1.0, 1e-15);
    for (double x = -2.0; x <= 4.0; x += 0.001) {
      EXPECT_NEAR(decodeSrgb(encodeSrgb(x)), x, 2e-8 + 1e-12);
      EXPECT_NEAR(encodeSrgb(-x), -encodeSrgb(x), 0.0);
      QVERIFY(encodeSrgb(x) < encodeSrgb(x + 0.001));
    }
  }

  // Chardon, Cretois, Hourseau 1991: atan((L* − 50) / b*) in degrees; above 55° very light, below
  // −30° dark.
  void typologyAngle() {
    EXPECT_NEAR(individualTypologyAngle({70.0, 10.0, 20.0}), 45.0, 1e-12);
    EXPECT_NEAR(individualTypologyAngle({50.0, 10.0, 20.0}), 0.0, 1e-12);
    EXPECT_NEAR(individualTypologyAngle({30.0, 10.0, 20.0}), -45.0, 1e-12);
    QVERIFY(individualTypologyAngle({75.0, 5.0, 12.0}) > 55.0);
    QVERIFY(individualTypologyAngle({32.0, 8.0, 12.0}) < -30.0);
  }

  void notANumberPassesThrough() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(std::isnan(lightness(nan)));
    QVERIFY(std::isnan(encodeSrgb(nan)) && std::isnan(decodeSrgb(nan)));
    QVERIFY(std::isnan(labFromXyz({nan, 1, 1}, kD65)[1]));
    QVERIFY(std::isnan(deltaE2000({nan, 0, 0}, {50, 0, 0})));
  }
};

CUTIS_TEST(ColorimetryTest)

}  // namespace
}  // namespace cutis

#include "colorimetry_test.moc"
