#include "ui/plot/spectrum_plot.h"

#include <cmath>

#include <QtTest>

#include "core/spectra/grid.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

QVector<double> flat(double value) {
  return QVector<double>(kSampleCount, value);
}

// Pixels of about this colour in one column of the picture.
int countIn(const QImage& image, int x, const QColor& color) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    const QColor pixel = image.pixelColor(x, y);
    const int apart = std::abs(pixel.red() - color.red()) +
                      std::abs(pixel.green() - color.green()) +
                      std::abs(pixel.blue() - color.blue());
    count += apart < 60 ? 1 : 0;
  }
  return count;
}

class SpectrumPlotTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    plot_.resize(800, 240);
    plot_.show();
    QVERIFY(QTest::qWaitForWindowExposed(&plot_));
  }
  void init() { plot_.clear(); }

  void curvesLieWhereTheirValuesAre() {
    plot_.setCurves(flat(0.4), {});
    const QImage image = plot_.grab().toImage();
    for (const double nm : {350.0, 550.0, 950.0}) {
      // The pixel that a line of two pixels covers wholly.
      const QPointF point = plot_.pointAt(nm, 0.4);
      const QPoint place(static_cast<int>(point.x()), static_cast<int>(point.y()));
      const QColor seen = image.pixelColor(place);
      EXPECT_NEAR(seen.blue(), theme::tones().original.blue(), 60);
      QCOMPARE(countIn(image, place.x(), theme::tones().edited), 0);
    }
  }

  void theEditedCurveIsDashed() {
    plot_.setCurves(flat(0.4), flat(0.2));
    const QImage image = plot_.grab().toImage();
    const int from = plot_.pointAt(320, 0).toPoint().x();
    const int to = plot_.pointAt(680, 0).toPoint().x();
    int drawn = 0;
    for (int x = from; x < to; ++x)
      drawn += countIn(image, x, theme::tones().edited) > 0 ? 1 : 0;
    const double share = static_cast<double>(drawn) / (to - from);
    QVERIFY2(share > 0.4 && share < 0.85, qPrintable(QString::number(share)));
  }

  void theAxisEndsAtARoundNumber() {
    plot_.setCurves(flat(0.41), flat(0.55));
    EXPECT_NEAR(plot_.maximum(), 0.6, 1e-9);
    plot_.setCurves(flat(0.041), {});
    EXPECT_NEAR(plot_.maximum(), 0.05, 1e-9);
    plot_.setMeasured({{"white, G", 540, 40, 0.3, 0.05}});
    EXPECT_NEAR(plot_.maximum(), 0.4, 1e-9);
    plot_.clear();
    EXPECT_NEAR(plot_.maximum(), 1, 1e-9);
  }

  void gapsAndForeignLengthsAreHarmless() {
    QVector<double> curve = flat(0.4);
    for (int i = 0; i < 200; ++i)
      curve[i] = std::nan("");
    plot_.setCurves(curve, {0.1, 0.2});
    const QImage image = plot_.grab().toImage();
    QCOMPARE(countIn(image, plot_.pointAt(500, 0).toPoint().x(), theme::tones().original), 0);
    QVERIFY(countIn(image, plot_.pointAt(900, 0).toPoint().x(), theme::tones().original) > 0);
  }

  void theCrosshairFollowsTheMouse() {
    plot_.setCurves(flat(0.4), flat(0.3));
    QTest::mouseMove(&plot_, plot_.pointAt(600, 0.5).toPoint());
    QVERIFY(plot_.crosshair());
    EXPECT_NEAR(wavelengthNm(*plot_.crosshair()), 600, 2);
    plot_.grab();
    QTest::mouseMove(&plot_, {2, 100});
    QVERIFY(!plot_.crosshair());
  }

  void theKeyboardMovesItToo() {
    plot_.setCurves(flat(0.4), {});
    QTest::keyClick(&plot_, Qt::Key_Home);
    QTest::keyClick(&plot_, Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(plot_.crosshair().value_or(-1), 1);
    QTest::keyClick(&plot_, Qt::Key_Left);
    QCOMPARE(plot_.crosshair().value_or(-1), 0);
    QTest::keyClick(&plot_, Qt::Key_Escape);
    QVERIFY(!plot_.crosshair());
  }

 private:
  SpectrumPlot plot_;
};

CUTIS_TEST(SpectrumPlotTest)

}  // namespace
}  // namespace cutis

#include "spectrum_plot_test.moc"
