// The layout of plots: words keep clear of each other and within the picture at any size, nothing
// is drawn outside its panel, and figures that are none leave gaps.

#include <algorithm>
#include <cmath>
#include <limits>

#include <QtTest>

#include "src/report/plot/clipping.h"
#include "src/report/plot/label_placement.h"
#include "src/report/plot/panel_drawing.h"
#include "src/report/plot/panel_layout.h"
#include "src/report/svg.h"
#include "tests/src/report/plot_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

const double kNan = std::nan("");
constexpr double kInfinite = std::numeric_limits<double>::infinity();

Drawing drawingOf(const Panel& panel, double width, double height) {
  Drawing drawing;
  drawing.width = width;
  drawing.height = height;
  const PanelLayout layout =
      layOut(panel, Box{0.0, 0.0, width, height}, printTheme(), printMetrics());
  drawFrame(drawing, panel, layout, printTheme(), printMetrics());
  drawContents(drawing, panel, layout, printTheme(), printMetrics());
  return drawing;
}

template <typename Kind>
std::vector<Kind> allOf(const Drawing& drawing) {
  std::vector<Kind> found;
  for (const Primitive& primitive : drawing.primitives) {
    if (const Kind* one = std::get_if<Kind>(&primitive)) found.push_back(*one);
  }
  return found;
}

// The pieces of the curve alone: its colour and width are no other's.
std::vector<Polyline> curvePieces(const Panel& panel) {
  std::vector<Polyline> pieces;
  for (const Polyline& line : allOf<Polyline>(drawingOf(panel, 400.0, 300.0))) {
    if (line.stroke == panel.curves.front().stroke) pieces.push_back(line);
  }
  return pieces;
}

Panel panelOf(std::vector<double> x, std::vector<double> y) {
  Panel panel;
  panel.x = linearAxis(0.0, 4.0, 4);
  panel.y = linearAxis(0.0, 1.0, 5);
  panel.curves = {{std::move(x), std::move(y), {Color::rgb(0xff00ff), 3.0}, {}}};
  return panel;
}

class PlotLayoutTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void wordsKeepClear_data() {
    QTest::addColumn<double>("width");
    QTest::addColumn<double>("height");
    for (const double width : {260.0, 340.0, 500.0, 900.0}) {
      for (const double height : {190.0, 300.0, 600.0})
        QTest::addRow("%g x %g", width, height) << width << height;
    }
  }

  void wordsKeepClear() {
    QFETCH(double, width);
    QFETCH(double, height);
    Panel panel = richPanel();
    QCOMPARE(untidyWords(drawingOf(panel, width, height), printMetrics()), std::string());
    panel.y = decadeAxis(3e-9, 0.5);
    panel.y.title = "error";
    panel.x = logarithmicAxis(300.0, 1000.0);
    QCOMPARE(untidyWords(drawingOf(panel, width, height), printMetrics()), std::string());
  }

  void axesOfManyNumbersAreThinned() {
    Panel panel = panelOf({}, {});
    panel.x = linearAxis(0.0, 10000.0, 100);
    panel.y = logarithmicAxis(1e-9, 1e3);
    const std::string untidy = untidyWords(drawingOf(panel, 300.0, 160.0), printMetrics());
    QVERIFY2(untidy.empty(), untidy.c_str());
    QVERIFY(textBoxes(drawingOf(panel, 300.0, 160.0), printMetrics()).size() > 4);
  }

  void pagesOfManyPanelsKeepClear() {
    Page page;
    page.heading = "A heading";
    page.introduction = {
        "What is to be seen, in a sentence that takes more than a single line of "
        "this picture, whose width is not enough for all of it."};
    page.notes = page.introduction;
    page.width = 620.0;
    for (const std::size_t count : {1u, 2u, 3u}) {
      PanelRow row;
      row.title = "A row";
      row.panels.assign(count, richPanel());
      page.rows.push_back(row);
    }
    const Drawing drawing = layOut(page);
    QCOMPARE(untidyWords(drawing, printMetrics()), std::string());
    QVERIFY(drawing == layOut(page));
  }

  // Above, curves and bars are cut off at the sides; the ground, axes and words may be anywhere.
  void nothingLeavesThePanel() {
    const std::vector<double> x = {-5.0, 1.0, 2.0, 9.0}, y = {0.5, 7.0, -3.0, 0.5};
    Panel panel = panelOf(x, y);
    const Box area = layOut(panel, Box{0.0, 0.0, 400.0, 300.0}, printTheme(), printMetrics()).area;
    const auto pieces = curvePieces(panel);
    QVERIFY(!pieces.empty());
    for (const Polyline& piece : pieces) {
      for (const Point& point : piece.points) {
        QVERIFY(point.x > area.left - 1e-9 && point.x < area.right + 1e-9);
        QVERIFY(point.y > area.top - 1e-9 && point.y < area.bottom + 1e-9);
      }
    }
  }

  void whatIsNoNumberLeavesAGap() {
    const std::vector<double> x = {0.0, 1.0, 2.0, 3.0, 4.0};
    QCOMPARE(curvePieces(panelOf(x, {0.1, 0.2, 0.3, 0.4, 0.5})).size(), std::size_t(1));
    QCOMPARE(curvePieces(panelOf(x, {0.1, 0.2, kNan, 0.4, 0.5})).size(), std::size_t(2));
    QCOMPARE(curvePieces(panelOf(x, {0.1, kInfinite, 0.3, 0.4, 0.5})).size(), std::size_t(1));
    QCOMPARE(curvePieces(panelOf(x, {kNan, 0.2, kNan, 0.4, kNan})).size(), std::size_t(0));
    Panel logarithmic = panelOf(x, {0.1, 0.2, 0.0, 0.4, 0.5});
    logarithmic.y = logarithmicAxis(0.01, 1.0);
    QCOMPARE(curvePieces(logarithmic).size(), std::size_t(2));
  }

  void anyFiguresCanBeDrawn() {
    for (const double from : {kNan, -kInfinite, 0.0, 1.0}) {
      for (const double to : {kNan, kInfinite, 0.0, 1.0}) {
        for (const bool logarithmic : {false, true}) {
          Panel panel = richPanel();
          panel.x = logarithmic ? logarithmicAxis(from, to) : linearAxis(from, to, 5);
          panel.y = panel.x;
          panel.points.front().y = panel.levels.front().value = from;
          panel.ribbons.front().low[3] = to;
          const std::string svg = svgOf(drawingOf(panel, 300.0, 200.0), "Sans");
          QVERIFY(svg.find("nan") == std::string::npos && svg.find("inf") == std::string::npos);
        }
      }
    }
    drawingOf(Panel(), 300.0, 200.0);
    drawingOf(richPanel(), 1.0, 1.0);
    layOut(Page());
  }

  void onePointIsDrawn() {
    Panel panel = panelOf({2.0}, {0.5});
    panel.curves.front().marker = Marker{Color::rgb(0xff00ff), 3.0};
    const auto discs = allOf<Disc>(drawingOf(panel, 400.0, 300.0));
    QCOMPARE(discs.size(), std::size_t(1));
    const PanelLayout layout =
        layOut(panel, Box{0.0, 0.0, 400.0, 300.0}, printTheme(), printMetrics());
    QVERIFY(discs[0].centre == layout.at(2.0, 0.5));
  }

  void theCursorTakesThePlaceOfItsNeighbours() {
    Panel panel = richPanel();
    panel.cursor = Tick{512.0, "512 nm", {}, false};
    const auto boxes = textBoxes(drawingOf(panel, 600.0, 300.0), printMetrics());
    const auto count = [&](const std::string& words) {
      return std::count_if(boxes.begin(), boxes.end(),
                           [&](const TextBox& box) { return box.words == words; });
    };
    QCOMPARE(count("512 nm"), 1);
    QCOMPARE(count("500"), 0);
    QCOMPARE(count("700"), 1);
  }

  void messagesStandForAllElse() {
    Panel panel = richPanel();
    panel.message = "nothing yet";
    const Drawing drawing = drawingOf(panel, 500.0, 300.0);
    QVERIFY(allOf<Disc>(drawing).size() == 1);  // of the legend
    QVERIFY(allOf<Area>(drawing).empty());
  }

  void linesAreCutWhereTheyLeaveABox() {
    const Box box = {0.0, 0.0, 10.0, 10.0};
    const std::vector<Point> line = {
        {-10.0, 5.0}, {5.0, 5.0}, {5.0, 30.0}, {8.0, 30.0}, {8.0, -30.0}};
    const auto pieces = clipped(line, box);
    QCOMPARE(pieces.size(), std::size_t(2));
    QVERIFY(pieces[0] == std::vector<Point>({{0.0, 5.0}, {5.0, 5.0}, {5.0, 10.0}}));
    QVERIFY(pieces[1] == std::vector<Point>({{8.0, 10.0}, {8.0, 0.0}}));
  }

  // Crowds of points such as methods of like speed and error make them.
  void labelsKeepClear_data() {
    QTest::addColumn<double>("spread");
    for (const double spread : {0.0, 3.0, 12.0, 40.0, 160.0})
      QTest::addRow("%g", spread) << spread;
  }

  void labelsKeepClear() {
    QFETCH(double, spread);
    const Box area = {0.0, 0.0, 800.0, 330.0};
    const std::vector<Box> taken = {{0.0, 160.0, 800.0, 164.0}};
    std::vector<LabelledPoint> points;
    for (int i = 0; i < 6; ++i) {
      points.push_back(
          {{400.0 + spread * std::cos(2.4 * i), 150.0 + 0.6 * spread * std::sin(2.4 * i)},
           5.0,
           "three stages, exhaustive"});
    }
    const auto labels = placeLabels(points, taken, area, printTheme().label, printMetrics());
    QCOMPARE(labels.size(), points.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
      QVERIFY(area.holds(labels[i].box));
      QVERIFY(!taken[0].overlaps(labels[i].box));
      for (const LabelledPoint& point : points) {
        const Box marker = {point.at.x - 5.0, point.at.y - 5.0, point.at.x + 5.0, point.at.y + 5.0};
        QVERIFY(!marker.overlaps(labels[i].box));
      }
      for (std::size_t k = 0; k < i; ++k)
        QVERIFY(!labels[k].box.overlaps(labels[i].box));
    }
  }

  // A small plot, primitive by primitive: what all back ends draw.
  void aSmallPlotIsThis() {
    Panel panel;
    panel.x = linearAxis(0.0, 1.0, 1);
    panel.y = linearAxis(0.0, 1.0, 1);
    panel.y.hasGrid = panel.x.hasGrid = false;
    panel.curves = {{{0.0, 1.0}, {0.0, 2.0}, {Color::rgb(0xff0000), 2.0}, {}}};
    const PlotTheme& theme = printTheme();
    const PanelLayout layout = {
        {20.0, 10.0, 120.0, 60.0}, 0.0, 10.0, 130.0, {0.0, 1.0, 20.0, 120.0},
        {0.0, 1.0, 60.0, 10.0}};
    Drawing drawing;
    drawFrame(drawing, panel, layout, theme, printMetrics());
    drawContents(drawing, panel, layout, theme, printMetrics());
    const double below = 64.0 + 0.93 * theme.tick.size, rise = 0.36 * theme.tick.size;
    Drawing expected;
    const Stroke axis = {theme.frame, 1.0};
    expected.line({20.0, 60.0}, {120.0, 60.0}, axis);
    expected.add(Text{{12.0, 60.0 + rise}, "0", theme.tick, Anchor::end});
    expected.add(Text{{12.0, 10.0 + rise}, "1", theme.tick, Anchor::end});
    expected.line({20.0, 60.0}, {20.0, 64.0}, axis);
    expected.line({120.0, 60.0}, {120.0, 64.0}, axis);
    expected.add(Text{{20.0, below}, "0", theme.tick, Anchor::middle});
    expected.add(Text{{120.0, below}, "1", theme.tick, Anchor::middle});
    expected.add(Rectangle{layout.area, kNoColor, axis, 0.0});
    expected.line({20.0, 60.0}, {70.0, 10.0}, {Color::rgb(0xff0000), 2.0});
    QCOMPARE(svgOf(drawing, "Sans"), svgOf(expected, "Sans"));
    QVERIFY(drawing == expected);
  }
};

CUTIS_TEST(PlotLayoutTest)

}  // namespace
}  // namespace cutis::test

#include "plot_layout_test.moc"
