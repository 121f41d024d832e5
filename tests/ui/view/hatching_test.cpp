#include "ui/view/hatching.h"

#include <cstdlib>
#include <set>

#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/color/hatch_pattern.h"
#include "ui/view/view_geometry.h"

namespace cutis {
namespace {

// 4 × 1 samples of 25 × 100 pixels in a view as large: nothing, then each mark.
MarkedSamples samplesOf() {
  return {{0, kNotSkin, kAtBound, kMostlyPrior}, {0, 0, 100, 25}, 25};
}

ViewGeometry geometryOf(int scale) {
  ViewGeometry geometry;
  geometry.setPicture({100, 25});
  geometry.setView({100 * scale, 25 * scale}, 0);
  return geometry;
}

// The columns of one sample.
QImage cellOf(const QImage& layer, int sample) {
  const int side = layer.width() / 4;
  return layer.copy(sample * side, 0, side, side);
}

std::set<QRgb> colorsOf(const QImage& image) {
  std::set<QRgb> colors;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x)
      colors.insert(image.pixel(x, y));
  }
  return colors;
}

class HatchingTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void whatIsNotMarkedStaysClear() {
    const QImage layer = hatchLayer(samplesOf(), geometryOf(2), {200, 50}, 1);
    QCOMPARE(colorsOf(cellOf(layer, 0)), std::set<QRgb>{0x00000000});
    QVERIFY(colorsOf(hatchLayer({}, geometryOf(2), {200, 50}, 1)) == std::set<QRgb>{0x00000000});
  }

  // Seen on dark and on light, with the value still visible between.
  void everyMarkIsLightAndDarkAndLeavesSight() {
    const QImage layer = hatchLayer(samplesOf(), geometryOf(2), {200, 50}, 1);
    for (int sample = 1; sample <= 3; ++sample)
      QCOMPARE(colorsOf(cellOf(layer, sample)),
               (std::set<QRgb>{0x00000000, 0xff000000, 0xffffffff}));
  }

  void marksDifferInShape() {
    const QImage layer = hatchLayer(samplesOf(), geometryOf(2), {200, 50}, 1);
    // Lines rise, fall or are dots: the same place of one is not that of another.
    QVERIFY(cellOf(layer, 1) != cellOf(layer, 2));
    QVERIFY(cellOf(layer, 2) != cellOf(layer, 3));
    QVERIFY(cellOf(layer, 1) != cellOf(layer, 3));
    std::set<QString> texts;
    for (const PixelMark mark : kPixelMarks)
      texts.insert(markText(mark));
    QCOMPARE(texts.size(), kPixelMarks.size());
  }

  // Zoomed in, lines are as thin; on a display at 2 × they are twice as many pixels.
  void linesKeepTheirSizeOnTheScreen() {
    const auto lit = [](const QImage& cell) {
      int count = 0;
      for (int x = 0; x < cell.width(); ++x)
        count += cell.pixel(x, 0) == 0xffffffff ? 1 : 0;
      return count;
    };
    const QImage near = hatchLayer(samplesOf(), geometryOf(8), {800, 200}, 1);
    const QImage sharp = hatchLayer(samplesOf(), geometryOf(8), {800, 200}, 2);
    const int one = lit(cellOf(near, 1)), two = lit(cellOf(sharp, 1));
    QVERIFY(std::abs(one - 200 / 9) <= 2);
    QVERIFY(std::abs(two - one) <= 3);  // half as many, twice as thick
  }
};

CUTIS_TEST(HatchingTest)

}  // namespace
}  // namespace cutis

#include "hatching_test.moc"
