// Ottosson 2020 for OKLab; Viénot, Brettel and Mollon 1999 for simulated deuteranopia.

#include "ui/color/color_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/color/oklab.h"

namespace cutis {
namespace {

// Eight bits round steps between neighbours to a fifth of themselves: uniformity is looked at over
// this many entries.
constexpr int kStride = 15;

double linear(int code) {
  const double v = code / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

// The way back of toSrgb(), for a table that holds eight bits.
OkLab toOkLab(QRgb color) {
  const double r = linear(qRed(color));
  const double g = linear(qGreen(color));
  const double b = linear(qBlue(color));
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

OkLab entry(const ColorScale& scale, int index) {
  return toOkLab(scale.table()[static_cast<std::size_t>(index)]);
}

int encoded(double v) {
  const double c = std::clamp(v, 0.0, 1.0);
  return static_cast<int>(
      std::lround(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055)));
}

QRgb asDeuteranope(QRgb color) {
  const double r = linear(qRed(color)), g = linear(qGreen(color)), b = linear(qBlue(color));
  const double rg = 0.29275 * r + 0.70725 * g;
  const double blue = -0.02234 * r + 0.02234 * g + b;
  return qRgb(encoded(rg), encoded(rg), encoded(blue));
}

class ColorScaleTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void okLabIsTheOneOfItsAuthor() {
    const OkLab white = toOkLab(qRgb(255, 255, 255));
    EXPECT_NEAR(white.lightness, 1.0, 1e-6);
    const OkLab red = toOkLab(qRgb(255, 0, 0));
    EXPECT_NEAR(red.lightness, 0.627955, 1e-5);
    EXPECT_NEAR(red.a, 0.224863, 1e-5);
    EXPECT_NEAR(red.b, 0.125846, 1e-5);
  }

  void okLabComesBack() {
    for (const QRgb color : {qRgb(12, 34, 56), qRgb(200, 3, 99), qRgb(255, 255, 0)}) {
      QCOMPARE(toSrgb(toOkLab(color)), color);
    }
  }

  void lightnessRises_data() { scales(); }
  void lightnessRises() {
    QFETCH(ScaleKind, kind);
    const ColorScale& scale = ColorScale::of(kind);
    for (int i = 5; i < 256; i += 5) {
      const double rise = entry(scale, i).lightness - entry(scale, i - 5).lightness;
      QVERIFY2(rise > 0, qPrintable(QString("entry %1 rises by %2").arg(i).arg(rise)));
    }
  }

  void stepsAreUniform_data() {
    scales();
    QTest::newRow("diverging") << ScaleKind::diverging;
  }
  void stepsAreUniform() {
    QFETCH(ScaleKind, kind);
    const ColorScale& scale = ColorScale::of(kind);
    double sum = 0, least = 1, most = 0;
    int count = 0;
    for (int i = kStride; i < 256; i += kStride) {
      // The path turns at the middle of the diverging scale; straight across is shorter.
      const bool turns = kind == ScaleKind::diverging && i > 127 && i - kStride < 127;
      if (turns) continue;
      ++count;
      const double step = distance(entry(scale, i - kStride), entry(scale, i));
      sum += step;
      least = std::min(least, step);
      most = std::max(most, step);
    }
    const double mean = sum / count;
    EXPECT_AT_MOST(most, 1.2 * mean);
    EXPECT_AT_MOST(0.8 * mean, least);
  }

  // The order is still that of lightness, and neighbours stay apart.
  void deuteranopesSeeTheOrder() {
    const ColorScale& scale = ColorScale::of(ScaleKind::sequential);
    for (int i = 5; i < 256; i += 5) {
      const auto seen = [&](int k) {
        return toOkLab(asDeuteranope(scale.table()[static_cast<std::size_t>(k)])).lightness;
      };
      QVERIFY2(seen(i) > seen(i - 5), qPrintable(QString("entry %1").arg(i)));
    }
  }

  void divergesFromALightMiddle() {
    const ColorScale& scale = ColorScale::of(ScaleKind::diverging);
    for (int i = 8; i < 120; i += 8) {
      QVERIFY(entry(scale, i).lightness > entry(scale, i - 8).lightness);
      QVERIFY(entry(scale, 255 - i).lightness > entry(scale, 263 - i).lightness);
    }
    QVERIFY(entry(scale, 0).b < -0.05 && entry(scale, 255).b > 0.05);
  }

  void greyIsNeutral() {
    for (const QRgb color : ColorScale::of(ScaleKind::grey).table()) {
      QVERIFY(qRed(color) == qGreen(color) && qGreen(color) == qBlue(color));
    }
  }

  void valuesAreClampedToTheRange() {
    const ColorScale& scale = ColorScale::of(ScaleKind::sequential);
    QCOMPARE(scale.at(-5, 0, 2), scale.table().front());
    QCOMPARE(scale.at(1, 0, 2), scale.table()[128]);
    QCOMPARE(scale.at(std::numeric_limits<double>::infinity(), 0, 2), scale.table().back());
    QCOMPARE(scale.at(3, 3, 3), scale.table().front());
    QCOMPARE(scale.at(std::nan(""), 0, 2), kMaskedColor);
  }

  void maskedIsNoColourOfTheScales() {
    for (const QRgb color : ColorScale::of(ScaleKind::sequential).table()) {
      QVERIFY(distance(toOkLab(color), toOkLab(kMaskedColor)) > 0.04);
    }
    QVERIFY(maskedPixel(0, 0) != maskedPixel(4, 0));
    QCOMPARE(maskedPixel(3, 4), maskedPixel(4, 3));
  }

 private:
  static void scales() {
    QTest::addColumn<ScaleKind>("kind");
    QTest::newRow("sequential") << ScaleKind::sequential;
    QTest::newRow("grey") << ScaleKind::grey;
  }
};

CUTIS_TEST(ColorScaleTest)

}  // namespace
}  // namespace cutis

#include "color_scale_test.moc"
