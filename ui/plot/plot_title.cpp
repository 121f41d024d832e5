#include "ui/plot/plot_title.h"

#include <QFontMetricsF>
#include <QPainter>

#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr double kSample = 24;

// Right-aligned; returns where the next entry ends.
double drawEntry(QPainter& painter, const QRectF& line, double right, const LegendEntry& entry) {
  const double width = QFontMetricsF(painter.font()).horizontalAdvance(entry.text) + 2;
  painter.setPen(theme::tones().text);
  painter.drawText(QRectF(right - width, line.top(), width, line.height()),
                   Qt::AlignRight | Qt::AlignVCenter, entry.text);
  const QPointF end(right - width - theme::kHalfSpace - 2, line.center().y());
  painter.setPen(entry.pen);
  painter.drawLine(end - QPointF(kSample, 0), end);
  if (entry.pointRadius > 0) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(entry.pen.color());
    painter.drawEllipse(end - QPointF(kSample / 2, 0), entry.pointRadius, entry.pointRadius);
  }
  return end.x() - kSample - theme::kDoubleSpace;
}

}  // namespace

QPen firstCurvePen() {
  return QPen(theme::tones().original, 2);
}

QPen secondCurvePen() {
  QPen pen(theme::tones().edited, 2);
  pen.setDashPattern({4, 2.5});
  pen.setCapStyle(Qt::FlatCap);
  return pen;
}

void drawPlotTitle(QPainter& painter, const QRectF& line, const QString& heading,
                   const std::vector<LegendEntry>& legend) {
  painter.save();
  double right = line.right();
  for (auto entry = legend.rbegin(); entry != legend.rend(); ++entry) {
    right = drawEntry(painter, line, right, *entry);
  }
  const double room = right - line.left();
  QFont bold = painter.font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(theme::tones().text);
  painter.drawText(QRectF(line.left(), line.top(), room, line.height()),
                   Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetricsF(bold).elidedText(heading, Qt::ElideRight, room));
  painter.restore();
}

}  // namespace cutis
