#include "ui/plot/locus_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>

#include "ui/plot/window_theme.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

// Around skin and white, with room for make-up and a wrong white balance; wider where skin of the
// profile is.
constexpr double kFromU = 0.17, kToU = 0.32;
constexpr double kFromV = 0.43, kToV = 0.54;
constexpr int kMostTicks = 5;
constexpr QPointF kDaylight(0.1978, 0.4683);
constexpr double kCross = 5;

Marker whiteMark() {
  Marker mark;
  const QColor text = theme::tones().dimText;
  mark.color = {static_cast<std::uint8_t>(text.red()), static_cast<std::uint8_t>(text.green()),
                static_cast<std::uint8_t>(text.blue()), 255};
  mark.radius = 3;
  mark.isFilled = false;
  return mark;
}

}  // namespace

LocusPlot::LocusPlot(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Skin locus"));
  setAccessibleDescription(
      tr("Chromaticities of the picture over those that skin of the profile can have"));
}

void LocusPlot::setSheet(const std::vector<LocusCurve>& curves) {
  sheet_ = curves;
  bounds_ = QRectF(QPointF(kFromU, kFromV), QPointF(kToU, kToV));
  for (const LocusCurve& curve : curves) {
    for (const QPointF& point : curve.points)
      bounds_ |= QRectF(point, QSizeF(1e-6, 1e-6));
  }
  update();
}

void LocusPlot::setColors(std::vector<QPointF> colors) {
  colors_ = std::move(colors);
  update();
}

void LocusPlot::setCursor(const QPointF& color) {
  if (color == cursor_) return;
  cursor_ = color;
  update();
}

QSize LocusPlot::sizeHint() const {
  return {300, 260};
}

QSize LocusPlot::minimumSizeHint() const {
  return {180, 160};
}

QRectF LocusPlot::outside() const {
  return QRectF(rect()).adjusted(0, 0, 0, -theme::kHalfSpace);
}

QPointF LocusPlot::placeOf(const QPointF& color) {
  const Point place = view_.layOut(panel(), outside(), font()).at(color.x(), color.y());
  return {place.x, place.y};
}

void LocusPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Panel shown = panel();
  view_.paint(painter, shown, outside(), font());
  if (!shown.message.empty()) return;
  const PanelLayout layout = view_.layOut(shown, outside(), font());
  painter.drawImage(QPointF(layout.area.left, layout.area.top), density(layout));
  if (cursor_.isNull() || !bounds_.contains(cursor_)) return;
  const Point at = layout.at(cursor_.x(), cursor_.y());
  painter.setPen(theme::tones().text);
  painter.drawLine(QPointF(at.x - kCross, at.y), QPointF(at.x + kCross, at.y));
  painter.drawLine(QPointF(at.x, at.y - kCross), QPointF(at.x, at.y + kCross));
}

// The share of the colours at each place, on a logarithmic scale: few are seen beside many.
QImage LocusPlot::density(const PanelLayout& layout) const {
  const int width = std::max(1, static_cast<int>(layout.area.width()));
  const int height = std::max(1, static_cast<int>(layout.area.height()));
  std::vector<int> counts(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (const QPointF& color : colors_) {
    if (!bounds_.contains(color)) continue;
    const Point at = layout.at(color.x(), color.y());
    const int x = static_cast<int>(at.x - layout.area.left);
    const int y = static_cast<int>(at.y - layout.area.top);
    if (x < 0 || y < 0 || x >= width || y >= height) continue;
    ++counts[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
             static_cast<std::size_t>(x)];
  }
  const int most = *std::max_element(counts.begin(), counts.end());
  QImage image(width, height, QImage::Format_ARGB32);
  image.fill(Qt::transparent);
  const QColor accent = theme::tones().edited;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int count = counts[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x)];
      if (count == 0) continue;
      const double share = std::log1p(count) / std::log1p(most);
      const int alpha = 40 + static_cast<int>(130 * share);
      image.setPixelColor(x, y, QColor(accent.red(), accent.green(), accent.blue(), alpha));
    }
  }
  return image;
}

Panel LocusPlot::panel() {
  const PlotTheme& theme = view_.themeFor(font());
  Panel panel;
  panel.x = linearAxis(bounds_.left(), bounds_.right(), kMostTicks, localTickWords);
  panel.x.title = "u′";
  panel.y = linearAxis(bounds_.top(), bounds_.bottom(), kMostTicks, localTickWords);
  panel.y.title = "v′";
  if (sheet_.empty()) {
    panel.message = tr("Nothing is fitted yet").toStdString();
    return panel;
  }
  for (const LocusCurve& line : sheet_) {
    Curve curve;
    curve.stroke = line.isMelanin ? firstCurveStroke(theme) : secondCurveStroke(theme);
    curve.stroke.width = 1.0;
    for (const QPointF& point : line.points) {
      curve.x.push_back(point.x());
      curve.y.push_back(point.y());
    }
    panel.curves.push_back(curve);
  }
  panel.legend = {{tr("constant melanin").toStdString(), firstCurveStroke(theme), {}},
                  {tr("constant blood").toStdString(), secondCurveStroke(theme), {}}};
  PlotPoint white;
  white.x = kDaylight.x();
  white.y = kDaylight.y();
  white.marker = whiteMark();
  white.label = tr("D65").toStdString();
  panel.points.push_back(white);
  return panel;
}

}  // namespace cutis
