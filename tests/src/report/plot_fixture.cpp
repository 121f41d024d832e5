#include "tests/src/report/plot_fixture.h"

#include <cmath>

namespace cutis::test {
namespace {

constexpr double kCapital = 0.7;  // of the font's size

}  // namespace

Panel richPanel() {
  const PlotTheme& theme = printTheme();
  Panel panel;
  panel.title = "A title";
  panel.legend = {{"first", {theme.series.orange, 1.8}, {}},
                  {"second", {theme.series.blue, 1.8, 6.0, 4.0}, Marker{theme.series.blue}}};
  panel.x = linearAxis(300.0, 1000.0, 7);
  panel.x.title = "wavelength";
  panel.x.unit = "nm";
  panel.y = linearAxis(0.0, 0.5, 5);
  panel.y.title = "reflectance";
  panel.shades = {{400.0, 700.0, theme.shade, "visible"}};
  panel.levels = {{0.42, {theme.series.green, 1.6, 7.0, 4.0}, "a bound"}};
  Curve curve;
  curve.stroke = {theme.series.orange, 1.8};
  Ribbon ribbon;
  ribbon.color = theme.series.orange.faded(70);
  for (double nm = 300.0; nm <= 1000.0; nm += 10.0) {
    const double value = 0.25 + 0.15 * std::sin(0.01 * nm);
    curve.x.push_back(nm);
    curve.y.push_back(value);
    ribbon.x.push_back(nm);
    ribbon.low.push_back(value - 0.02);
    ribbon.high.push_back(value + 0.02);
  }
  panel.curves = {curve};
  panel.ribbons = {ribbon};
  for (const double nm : {500.0, 510.0, 515.0}) {
    PlotPoint point;
    point.x = nm;
    point.y = 0.2;
    point.marker = {theme.series.purple};
    point.label = "point";
    point.across = {nm - 30.0, nm + 30.0};
    point.upwards = {0.15, 0.25};
    panel.points.push_back(point);
  }
  return panel;
}

std::vector<TextBox> textBoxes(const Drawing& drawing, const TextMetrics& metrics) {
  std::vector<TextBox> boxes;
  for (const Primitive& primitive : drawing.primitives) {
    const auto* text = std::get_if<Text>(&primitive);
    if (text == nullptr) continue;
    const double width = metrics.width(text->words, text->style);
    const double before = text->anchor == Anchor::start    ? 0.0
                          : text->anchor == Anchor::middle ? 0.5 * width
                                                           : width;
    const double height = kCapital * text->style.size;
    const Point at = text->at;
    Box box = {at.x - before, at.y - height, at.x - before + width, at.y};
    if (text->upwards) box = {at.x - height, at.y - width + before, at.x, at.y + before};
    boxes.push_back({text->words, box});
  }
  return boxes;
}

std::string untidyWords(const Drawing& drawing, const TextMetrics& metrics) {
  const Box whole = {0.0, 0.0, drawing.width, drawing.height};
  const auto boxes = textBoxes(drawing, metrics);
  std::string found;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!whole.holds(boxes[i].box)) found += "\"" + boxes[i].words + "\" leaves the drawing. ";
    for (std::size_t k = 0; k < i; ++k) {
      if (boxes[i].box.overlaps(boxes[k].box))
        found += "\"" + boxes[i].words + "\" lies on \"" + boxes[k].words + "\". ";
    }
  }
  return found;
}

}  // namespace cutis::test
