#include "ui/plot/loss_plot.h"

#include <cmath>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

bool isNear(const QColor& a, const QColor& b) {
  return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
             std::abs(a.blue() - b.blue()) <
         90;
}

// Whether a colour is seen within two pixels of a place.
bool isSeen(const QImage& image, const QPointF& place, const QColor& color) {
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) {
      const QPoint pixel = place.toPoint() + QPoint(x, y);
      if (image.valid(pixel) && isNear(image.pixelColor(pixel), color)) return true;
    }
  }
  return false;
}

class LossPlotTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    plot_.resize(560, 260);
    plot_.setCurves({{"First", 50, {}, {}}, {"Second", 40, {}, {}}});
  }

  void curvesLieWhereTheirErrorsAre() {
    const QVector<double> trained = {0.05, 0.01, 0.002}, heldOut = {0.002, 0.001, 0.0005};
    plot_.setCurves({{"First", 3, trained, heldOut}, {"Second", 3, trained, {}}});
    const QImage image = plot_.grab().toImage();
    QVERIFY(isSeen(image, plot_.pointAt(0, 2, 0.01), theme::tones().original));
    QVERIFY(isSeen(image, plot_.pointAt(1, 2, 0.01), theme::tones().original));
    QVERIFY(isSeen(image, plot_.pointAt(0, 1, 0.002), theme::tones().edited));
    QVERIFY(!isSeen(image, plot_.pointAt(1, 1, 0.002), theme::tones().edited));
  }

  // Equal ratios are equal distances; one network begins where the other ends.
  void theAxisIsLogarithmic() {
    plot_.setCurves({{"First", 3, {0.1}, {0.001}}, {"Second", 6, {}, {}}});
    const auto y = [&](double error) { return plot_.pointAt(0, 1, error).y(); };
    EXPECT_NEAR(y(0.001) - y(0.01), y(0.01) - y(0.1), 1e-6);
    EXPECT_NEAR(plot_.pointAt(0, 3, 0.01).x(), plot_.pointAt(1, 0, 0.01).x(), 1e-6);
    const double first = plot_.pointAt(0, 3, 0.01).x() - plot_.pointAt(0, 0, 0.01).x();
    const double second = plot_.pointAt(1, 6, 0.01).x() - plot_.pointAt(1, 0, 0.01).x();
    EXPECT_NEAR(second, 2 * first, 1e-6);
  }

  void whatIsNoErrorIsLeftOut() {
    const double infinity = std::numeric_limits<double>::infinity();
    plot_.setCurves({{"First", 5, {std::nan(""), 0, -1, infinity}, {std::nan("")}}});
    plot_.grab();
    plot_.setCurves({{"First", 5, {std::nan(""), 0.01, 0.005}, {infinity, 0.02, 0.0}}});
    QVERIFY(isSeen(plot_.grab().toImage(), plot_.pointAt(0, 2, 0.01), theme::tones().original));
  }

  void drawsWithoutCurvesAndSmall() {
    plot_.setCurves({});
    plot_.grab();
    plot_.resize(20, 20);
    plot_.setCurves({{"First", 1, {0.01}, {0.02}}});
    plot_.grab();
  }

 private:
  LossPlot plot_;
};

CUTIS_TEST(LossPlotTest)

}  // namespace
}  // namespace cutis

#include "loss_plot_test.moc"
