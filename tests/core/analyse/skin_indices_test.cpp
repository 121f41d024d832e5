// Indices against values that were worked out by hand from their formulas.

#include "core/analyse/skin_indices.h"

#include <cmath>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

void setAt(Spectrum& spectrum, int nm, double value) {
  spectrum[(nm - kFirstWavelengthNm) / kWavelengthStepNm] = value;
}

// Three boxes, so that a spectrum in steps has tristimulus values that a hand can add up.
SpectrumRows boxes() {
  SpectrumRows rows = SpectrumRows::Zero(3, kSampleCount);
  rows.block(0, 150, 1, 20).setConstant(0.95 / 20);  // X: 600–638 nm
  rows.block(1, 120, 1, 20).setConstant(1.0 / 20);   // Y: 540–578 nm
  rows.block(2, 70, 1, 20).setConstant(1.09 / 20);   // Z: 440–478 nm
  return rows;
}

class SkinIndicesTest : public QObject {
  Q_OBJECT

 private slots:
  // A power of ten at each wavelength makes the logarithms whole numbers.
  void logarithmsAreTakenAtTheirWavelengths() {
    Spectrum skin = Spectrum::Constant(1.0);
    setAt(skin, 510, 1e-1);  // p = 1
    setAt(skin, 540, 1e-2);  // q = 2
    setAt(skin, 560, 1e-3);  // r = 3
    setAt(skin, 580, 1e-4);  // s = 4
    setAt(skin, 610, 1e-5);  // t = 5
    setAt(skin, 650, 1e-6);
    setAt(skin, 700, 1e-8);
    const SkinIndices found = skinIndices(skin, boxes());
    EXPECT_NEAR(found.melanin, 100 * (6 + 8) / 2.0, 1e-9);
    EXPECT_NEAR(found.erythema, 100 * (3 - (6 + 1) / 2.0), 1e-9);
    EXPECT_NEAR(found.dawsonErythema, 100 * (3 + 1.5 * (2 + 4) - 2 * (1 + 5)), 1e-9);
  }

  // L* = 116 · 0.4^⅓ − 16 and b* = 200 (0.4^⅓ − 0.2^⅓).
  void theTypologyAngleIsThatOfTheColour() {
    Spectrum skin = Spectrum::Constant(0.4);
    skin.segment(70, 20).setConstant(0.2);
    const double y = std::cbrt(0.4), z = std::cbrt(0.2);
    const double wanted = std::atan((116 * y - 16 - 50) / (200 * (y - z))) * 180 / 3.14159265358979;
    EXPECT_NEAR(skinIndices(skin, boxes()).typologyAngle, wanted, 1e-9);
    const Eigen::Vector3d lab = labOf(skin, boxes());
    EXPECT_NEAR(lab[0], 116 * y - 16, 1e-9);
    EXPECT_NEAR(lab[2], 200 * (y - z), 1e-9);
  }

  void aPerfectDiffuserHasNeitherMelaninNorErythema() {
    const SkinIndices white = skinIndices(Spectrum::Ones(), boxes());
    EXPECT_NEAR(white.melanin, 0, 0);
    EXPECT_NEAR(white.erythema, 0, 0);
    EXPECT_NEAR(white.dawsonErythema, 0, 0);
    EXPECT_NEAR(labOf(Spectrum::Ones(), boxes())[0], 100, 1e-12);
  }

  void blackAndNaNHaveNoIndex() {
    Spectrum skin = Spectrum::Constant(0.3);
    setAt(skin, 650, 0.0);
    SkinIndices found = skinIndices(skin, boxes());
    QVERIFY(std::isnan(found.melanin) && std::isnan(found.erythema));
    QVERIFY(std::isfinite(found.dawsonErythema));
    setAt(skin, 580, std::nan(""));
    QVERIFY(std::isnan(skinIndices(skin, boxes()).dawsonErythema));
  }
};

CUTIS_TEST(SkinIndicesTest)

}  // namespace
}  // namespace cutis

#include "skin_indices_test.moc"
