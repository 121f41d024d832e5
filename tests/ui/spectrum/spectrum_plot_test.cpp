#include "ui/plot/spectrum_plot.h"

#include <cmath>
#include <utility>

#include <QApplication>
#include <QWheelEvent>
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

MeasuredChannel channelAt(double nm, double reflectance, double deviation) {
  return {"white.G", nm, 30, reflectance, deviation, reflectance};
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
  void init() {
    plot_.clear();
    plot_.setMeasured({});
  }

  void curvesLieWhereTheirValuesAre() {
    show(flat(0.4));
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
    show(flat(0.4), flat(0.2));
    const QImage image = plot_.grab().toImage();
    const double share = drawnShare(image, 320, 680, theme::tones().edited);
    QVERIFY2(share > 0.4 && share < 0.85, qPrintable(QString::number(share)));
  }

  // So that the next place can be compared with this one.
  void theAxisEndsAtTheLargestValueSeen() {
    show(flat(0.41), flat(0.55));
    EXPECT_NEAR(plot_.maximum(), 0.6, 1e-9);
    show(flat(0.041));
    EXPECT_NEAR(plot_.maximum(), 0.6, 1e-9);
    plot_.setPlace({}, {flat(0.1), {}, {}}, {channelAt(540, 0.7, 0.05)});
    EXPECT_NEAR(plot_.maximum(), 1.0, 1e-9);
    plot_.clear();
    EXPECT_NEAR(plot_.maximum(), 1.0, 1e-9);
    show(flat(0.041));
    EXPECT_NEAR(plot_.maximum(), 0.05, 1e-9);
  }

  void wheelAndKeysChooseTheAxisAndADoubleClickGivesItBack() {
    show(flat(0.41));
    EXPECT_NEAR(plot_.maximum(), 0.5, 1e-9);
    turnWheel(1);
    EXPECT_NEAR(plot_.maximum(), 0.4, 1e-9);
    show(flat(0.55));
    EXPECT_NEAR(plot_.maximum(), 0.4, 1e-9);
    QTest::keyClick(&plot_, Qt::Key_Down);
    QTest::keyClick(&plot_, Qt::Key_Down);
    EXPECT_NEAR(plot_.maximum(), 0.6, 1e-9);
    turnWheel(40);
    EXPECT_NEAR(plot_.maximum(), 0.01, 1e-9);
    QTest::mouseDClick(&plot_, Qt::LeftButton, {}, plot_.rect().center());
    QTest::mouseRelease(&plot_, Qt::LeftButton, {}, plot_.rect().center());
    EXPECT_NEAR(plot_.maximum(), 0.6, 1e-9);
  }

  void whatWasNotMeasuredIsDashed() {
    show(flat(0.4));
    plot_.setMeasured(Band{60, 190});  // 420 to 680 nm
    const QImage image = plot_.grab().toImage();
    EXPECT_NEAR(drawnShare(image, 430, 670, theme::tones().original), 1.0, 0.02);
    for (const auto& [from, to] : {std::pair(310, 410), std::pair(690, 990)}) {
      const double share = drawnShare(image, from, to, theme::tones().original);
      QVERIFY2(share > 0.3 && share < 0.8, qPrintable(QString::number(share)));
    }
    plot_.setMeasured({});
    EXPECT_NEAR(drawnShare(plot_.grab().toImage(), 310, 990, theme::tones().original), 1.0, 0.02);
  }

  // A disc with bars where it measured, across as wide as the channel.
  void channelsAreBarsAgainstTheCurve() {
    plot_.setPlace({}, {flat(0.2), {}, {}}, {channelAt(550, 0.3, 0.02)});
    const QImage image = plot_.grab().toImage();
    const QColor ink = theme::tones().text;
    QVERIFY(countIn(image, plot_.pointAt(550, 0).toPoint().x(), ink) > 5);
    QVERIFY(countIn(image, plot_.pointAt(570, 0).toPoint().x(), ink) > 0);
    QCOMPARE(countIn(image, plot_.pointAt(600, 0).toPoint().x(), ink), 0);
  }

  // In the infrared a chromophore may leave more reflectance than what it displaces.
  void contributionsBelowZeroAreSeen() {
    plot_.setParts(SpectrumQuantity::contributions,
                   {{"Melanin", flat(0.1)}, {"Blood", flat(-0.004)}});
    const QPointF low = plot_.pointAt(900, -0.004);
    QVERIFY(low.y() > plot_.pointAt(900, 0).y() + 2);
    QVERIFY(low.y() < plot_.height() - 20);
    plot_.setParts(SpectrumQuantity::reflectance);
  }

  void gapsAndForeignLengthsAreHarmless() {
    QVector<double> curve = flat(0.4);
    for (int i = 0; i < 200; ++i)
      curve[i] = std::nan("");
    show(curve, {0.1, 0.2});
    const QImage image = plot_.grab().toImage();
    QCOMPARE(countIn(image, plot_.pointAt(500, 0).toPoint().x(), theme::tones().original), 0);
    QVERIFY(countIn(image, plot_.pointAt(900, 0).toPoint().x(), theme::tones().original) > 0);
  }

  void theCrosshairFollowsTheMouse() {
    show(flat(0.4), flat(0.55));
    QTest::mouseMove(&plot_, plot_.pointAt(600, 0.5).toPoint());
    QVERIFY(plot_.crosshair());
    EXPECT_NEAR(wavelengthNm(*plot_.crosshair()), 600, 2);
    QVERIFY(plot_.pointedAt());
    EXPECT_NEAR(*plot_.pointedAt(), 0.5, 0.01);
    plot_.grab();
    QTest::mouseMove(&plot_, {2, 100});
    QVERIFY(!plot_.crosshair());
  }

  void theKeyboardMovesItToo() {
    show(flat(0.4));
    QTest::keyClick(&plot_, Qt::Key_Home);
    QTest::keyClick(&plot_, Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(plot_.crosshair().value_or(-1), 1);
    QTest::keyClick(&plot_, Qt::Key_Left);
    QCOMPARE(plot_.crosshair().value_or(-1), 0);
    QTest::keyClick(&plot_, Qt::Key_Escape);
    QVERIFY(!plot_.crosshair());
  }

 private:
  void show(const QVector<double>& original, const QVector<double>& edited = {}) {
    plot_.setPlace({}, {original, edited, {}});
  }
  void turnWheel(int notches) {
    const QPointF place(plot_.rect().center());
    QWheelEvent event(place, plot_.mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&plot_, &event);
  }
  // Of the columns between two wavelengths, those in which a colour is drawn.
  double drawnShare(const QImage& image, double fromNm, double toNm, const QColor& color) const {
    const int from = plot_.pointAt(fromNm, 0).toPoint().x();
    const int to = plot_.pointAt(toNm, 0).toPoint().x();
    int drawn = 0;
    for (int x = from; x < to; ++x)
      drawn += countIn(image, x, color) > 0 ? 1 : 0;
    return static_cast<double>(drawn) / (to - from);
  }

  SpectrumPlot plot_;
};

CUTIS_TEST(SpectrumPlotTest)

}  // namespace
}  // namespace cutis

#include "spectrum_plot_test.moc"
