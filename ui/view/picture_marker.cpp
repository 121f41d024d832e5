#include "ui/view/picture_marker.h"

#include <cmath>

#include <QFontMetricsF>
#include <QPainter>

namespace cutis {
namespace {

constexpr double kRadius = 6;
constexpr double kMarkerReach = 9;  // of the mouse
constexpr double kRingWidth = 2;
constexpr double kRim = 1.5;  // of dark around what is drawn, so that it is seen on any skin
constexpr double kGap = 4;
constexpr double kLeastSquare = 6;  // of an outline that can be seen
const QColor kDark(0, 0, 0, 200);

QPointF middleOf(const PictureMarker& marker, const ToWidget& toWidget) {
  return toWidget(QPointF(marker.pixel) + QPointF(0.5, 0.5));
}

void drawSquare(QPainter& painter, const PictureMarker& marker, const ToWidget& toWidget) {
  const QPointF corner = QPointF(marker.pixel) - QPointF(marker.size / 2, marker.size / 2);
  const QRectF square(toWidget(corner), toWidget(corner + QPointF(marker.size, marker.size)));
  if (square.width() < kLeastSquare) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kDark, 3));
  painter.drawRect(square);
  painter.setPen(QPen(marker.color, 1));
  painter.drawRect(square);
}

void drawMarker(QPainter& painter, const QFont& font, const PictureMarker& marker,
                const ToWidget& toWidget) {
  const QPointF middle = middleOf(marker, toWidget);
  drawSquare(painter, marker, toWidget);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kDark, kRingWidth + 2 * kRim));
  painter.drawEllipse(middle, kRadius, kRadius);
  painter.setPen(QPen(marker.color, marker.isSelected ? 1.5 * kRingWidth : kRingWidth));
  painter.drawEllipse(middle, kRadius, kRadius);
  painter.drawPoint(middle);
  const QString words = marker.name.isEmpty() ? marker.letter : marker.letter + ' ' + marker.name;
  const QFontMetricsF metrics(font);
  QRectF box(0, 0, metrics.horizontalAdvance(words) + 2 * kGap, metrics.height());
  box.moveLeft(middle.x() + kRadius + kGap);
  box.moveTop(middle.y() - 0.5 * box.height());
  painter.setPen(marker.isSelected ? QPen(marker.color, 1) : QPen(Qt::NoPen));
  painter.setBrush(kDark);
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(marker.color);
  painter.drawText(box, Qt::AlignCenter, words);
}

}  // namespace

void drawMarkers(QPainter& painter, const QFont& font, const QVector<PictureMarker>& markers,
                 const ToWidget& toWidget) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font);
  for (const PictureMarker& marker : markers)
    drawMarker(painter, font, marker, toWidget);
  painter.restore();
}

std::optional<int> markerAt(const QVector<PictureMarker>& markers, const QPointF& point,
                            const ToWidget& toWidget) {
  for (int i = static_cast<int>(markers.size()) - 1; i >= 0; --i) {
    const QPointF apart = middleOf(markers[i], toWidget) - point;
    if (std::hypot(apart.x(), apart.y()) <= kMarkerReach) return i;
  }
  return {};
}

}  // namespace cutis
