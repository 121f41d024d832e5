#include "ui/plot/paint_drawing.h"

#include <algorithm>
#include <cmath>

#include <QFontInfo>
#include <QPainter>
#include <QPolygonF>

namespace cutis {
namespace {

QString qtTextOf(std::string_view words) {
  return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

QColor paintColorOf(Color color) {
  return {color.red, color.green, color.blue, color.alpha};
}

QPointF pointOf(Point p) {
  return {p.x, p.y};
}

QRectF rectOf(const Box& box) {
  return {box.left, box.top, box.width(), box.height()};
}

QPolygonF polygonOf(const std::vector<Point>& points) {
  QPolygonF polygon;
  polygon.reserve(static_cast<qsizetype>(points.size()));
  for (const Point& point : points)
    polygon.append(pointOf(point));
  return polygon;
}

QPen penOf(const Stroke& stroke) {
  if (stroke.color.isNone()) return Qt::NoPen;
  QPen pen(paintColorOf(stroke.color), stroke.width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  // Qt counts dashes in widths of the line.
  if (stroke.dash > 0.0)
    pen.setDashPattern({stroke.dash / stroke.width, stroke.gap / stroke.width});
  return pen;
}

QBrush brushOf(Color fill) {
  return fill.isNone() ? QBrush(Qt::NoBrush) : QBrush(paintColorOf(fill));
}

class Painting {
 public:
  Painting(QPainter& painter, const PaintFonts& fonts) : painter_(painter), fonts_(fonts) {}

  void operator()(const Polyline& polyline) {
    const auto& points = polyline.points;
    const bool straight = points.size() == 2 && (points[0].x == points[1].x ||  //
                                                 points[0].y == points[1].y);
    prepare(polyline.stroke, kNoColor, !(straight && polyline.stroke.width <= 1.0));
    if (points.size() == 2) {
      painter_.drawLine(pointOf(points[0]), pointOf(points[1]));
    } else {
      painter_.drawPolyline(polygonOf(points));
    }
  }

  void operator()(const Area& area) {
    prepare(kNoStroke, area.fill, true);
    painter_.drawPolygon(polygonOf(area.points));
  }

  void operator()(const Rectangle& rectangle) {
    const bool round = rectangle.cornerRadius > 0.0;
    prepare(rectangle.stroke, rectangle.fill, round);
    if (round) {
      painter_.drawRoundedRect(rectOf(rectangle.box), rectangle.cornerRadius,
                               rectangle.cornerRadius);
    } else {
      painter_.drawRect(rectOf(rectangle.box));
    }
  }

  void operator()(const Disc& disc) {
    prepare(disc.stroke, disc.fill, true);
    painter_.drawEllipse(pointOf(disc.centre), disc.radius, disc.radius);
  }

  void operator()(const Text& text) {
    const QString words = qtTextOf(text.words);
    double before = 0.0;
    if (text.anchor != Anchor::start) {
      before = fonts_.metricsOf(text.style).horizontalAdvance(words);
      if (text.anchor == Anchor::middle) before *= 0.5;
    }
    painter_.setFont(fonts_.fontOf(text.style));
    painter_.setPen(paintColorOf(text.style.color));
    if (!text.upwards) {
      painter_.drawText(QPointF(text.at.x - before, text.at.y), words);
      return;
    }
    painter_.save();
    painter_.translate(pointOf(text.at));
    painter_.rotate(-90.0);
    painter_.drawText(QPointF(-before, 0.0), words);
    painter_.restore();
  }

 private:
  void prepare(const Stroke& stroke, Color fill, bool smooth) {
    painter_.setRenderHint(QPainter::Antialiasing, smooth);
    painter_.setPen(penOf(stroke));
    painter_.setBrush(brushOf(fill));
  }

  QPainter& painter_;
  const PaintFonts& fonts_;
};

}  // namespace

PaintFonts::PaintFonts(const QFont& font) : font_(font), baseSize_(QFontInfo(font).pixelSize()) {}

const PaintFonts::Set& PaintFonts::setOf(const TextStyle& style) const {
  const std::pair key(style.size, style.bold);
  const auto known = sets_.find(key);
  if (known != sets_.end()) return known->second;
  QFont font = font_;
  if (style.bold) font.setBold(true);
  if (style.size != baseSize_) {
    const double share = style.size / baseSize_;
    if (font.pointSizeF() > 0.0) {
      font.setPointSizeF(share * font.pointSizeF());
    } else {
      font.setPixelSize(std::max(1, static_cast<int>(std::lround(style.size))));
    }
  }
  return sets_.emplace(key, Set{font, QFontMetricsF(font)}).first->second;
}

double PaintFonts::width(std::string_view words, const TextStyle& style) const {
  return words.empty() ? 0.0 : metricsOf(style).horizontalAdvance(qtTextOf(words));
}

double PaintFonts::ascent(const TextStyle& style) const {
  return metricsOf(style).ascent();
}

double PaintFonts::descent(const TextStyle& style) const {
  return metricsOf(style).descent();
}

void paint(QPainter& painter, const Drawing& drawing, const PaintFonts& fonts) {
  painter.save();
  Painting painting(painter, fonts);
  for (const Primitive& primitive : drawing.primitives)
    std::visit(painting, primitive);
  painter.restore();
}

}  // namespace cutis
