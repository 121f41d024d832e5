// Drawings painted by QPainter look like their SVG: both back ends draw the same list.

#include "ui/plot/paint_drawing.h"

#include <cmath>

#include <QFontInfo>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <QtTest>

#include "src/report/svg.h"
#include "tests/support/test_registry.h"
#include "ui/plot/window_theme.h"

namespace cutis {
namespace {

constexpr QSize kSize(160, 120);

QImage canvas() {
  QImage image(kSize, QImage::Format_RGB32);
  image.fill(Qt::white);
  return image;
}

QImage painted(const Drawing& drawing) {
  QImage image = canvas();
  QPainter painter(&image);
  paint(painter, drawing, PaintFonts(QFont()));
  return image;
}

QImage rasterised(const Drawing& drawing) {
  QImage image = canvas();
  QSvgRenderer renderer(
      QByteArray::fromStdString(svgOf(drawing, QFontInfo(QFont()).family().toStdString())));
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  renderer.render(&painter);
  return image;
}

// Share of pixels that clearly differ.
double difference(const QImage& a, const QImage& b) {
  int apart = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x)
      apart += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 96 ? 1 : 0;
  }
  return static_cast<double>(apart) / (a.width() * a.height());
}

Drawing drawingOf(std::vector<Primitive> primitives) {
  Drawing drawing;
  drawing.width = kSize.width();
  drawing.height = kSize.height();
  drawing.primitives = std::move(primitives);
  return drawing;
}

class PaintDrawingTest : public QObject {
  Q_OBJECT

 private slots:
  void looksLikeItsSvg_data() {
    QTest::addColumn<Drawing>("drawing");
    const Color black = Color::rgb(0x000000);
    QTest::newRow("rectangle") << drawingOf(
        {Rectangle{{20, 20, 100, 90}, black, kNoStroke, 6.0},
         Rectangle{{110.5, 20.5, 140.5, 90.5}, kNoColor, {black, 1.0}, 0.0}});
    QTest::newRow("discs") << drawingOf(
        {Disc{{40, 40}, 20, black, kNoStroke}, Disc{{100, 70}, 25, kNoColor, {black, 4.0}}});
    QTest::newRow("area") << drawingOf({Area{{{10, 10}, {140, 30}, {60, 110}}, black}});
    QTest::newRow("polyline") << drawingOf(
        {Polyline{{{10, 100}, {60, 20}, {90, 90}, {150, 30}}, {black, 3.0}}});
    QTest::newRow("dashes") << drawingOf(
        {Polyline{{{10, 100}, {60, 20}, {90, 90}, {150, 30}}, {black, 4.0, 12.0, 6.0}}});
  }

  void looksLikeItsSvg() {
    QFETCH(Drawing, drawing);
    const QImage image = painted(drawing);
    QVERIFY(difference(image, canvas()) > 0.01);
    const double apart = difference(image, rasterised(drawing));
    QVERIFY2(apart < 0.004, qPrintable(QString::number(apart)));
  }

  // Words lie where the metrics say, whatever their anchor.
  void wordsLieWhereTheyAreAnchored() {
    const PaintFonts fonts{QFont()};
    const TextStyle style = {fonts.baseSize(), Color::rgb(0x000000)};
    const std::string words = "MMMM";
    const double width = fonts.width(words, style);
    QVERIFY(width > 10.0);
    const auto spanOf = [&](const Text& text) {
      const QImage image = painted(drawingOf({text}));
      QRect span;
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          if (qGray(image.pixel(x, y)) < 128) span |= QRect(x, y, 1, 1);
        }
      }
      return span;
    };
    const Point at = {80, 60};
    const QRect start = spanOf({at, words, style, Anchor::start});
    const QRect middle = spanOf({at, words, style, Anchor::middle});
    const QRect end = spanOf({at, words, style, Anchor::end});
    const QRect upwards = spanOf({at, words, style, Anchor::middle, true});
    QVERIFY(std::abs(start.left() - 80) <= 3 && std::abs(start.width() - width) <= 5);
    QVERIFY(std::abs(middle.center().x() - 80) <= 2);
    QVERIFY(std::abs(end.right() - 80) <= 3);
    QVERIFY(start.bottom() <= 61);
    QVERIFY(upwards.height() > 2 * upwards.width());
    QVERIFY(std::abs(upwards.center().y() - 60) <= 2 && upwards.right() <= 81);
  }

  void largerStylesAreLarger() {
    const PaintFonts fonts{QFont()};
    const TextStyle once = {fonts.baseSize(), {}}, twice = {2.0 * fonts.baseSize(), {}};
    const double ratio = fonts.width("words", twice) / fonts.width("words", once);
    QVERIFY2(ratio > 1.8 && ratio < 2.2, qPrintable(QString::number(ratio)));
    QVERIFY(fonts.ascent(twice) > 1.5 * fonts.ascent(once));
  }

  // Text of all kinds is read easily: 4.5 : 1 and more on both grounds of a plot.
  void theThemeHasContrast() {
    const PlotTheme theme = windowTheme(PaintFonts{QFont()});
    const auto luminance = [](Color color) {
      const auto linear = [](std::uint8_t value) {
        const double v = value / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
      };
      return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) +
             0.0722 * linear(color.blue);
    };
    for (const Color ground : {theme.ground, theme.shade, theme.outerShade}) {
      for (const Color color : {theme.ink, theme.muted, theme.series.orange, theme.series.blue,
                                theme.series.purple, theme.series.grey, theme.series.green}) {
        const double a = luminance(ground) + 0.05, b = luminance(color) + 0.05;
        QVERIFY(b / a > 4.5);
      }
    }
  }
};

CUTIS_TEST(PaintDrawingTest)

}  // namespace
}  // namespace cutis

#include "paint_drawing_test.moc"
