#include "ui/widgets/message_mark.h"

#include <QApplication>
#include <QPainter>

#include "ui/theme/theme.h"

namespace cutis {

QPixmap messageMark(bool isError) {
  constexpr int kSize = 14;
  const double ratio = qApp->devicePixelRatio();
  QPixmap pixmap(QSize(kSize, kSize) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  if (isError) {
    painter.setBrush(theme::tones().error);
    painter.drawPolygon(QPolygonF({{7, 0.5}, {13.8, 13}, {0.2, 13}}));
  } else {
    painter.setBrush(theme::tones().accent);
    painter.drawEllipse(QPointF(7, 7), 6.5, 6.5);
  }
  painter.setPen(QPen(theme::tones().field, 1.8, Qt::SolidLine, Qt::RoundCap));
  if (isError) {
    painter.drawLine(QPointF(7, 5), QPointF(7, 8.4));
    painter.drawPoint(QPointF(7, 11));
  } else {
    painter.drawPoint(QPointF(7, 4));
    painter.drawLine(QPointF(7, 6.8), QPointF(7, 10.2));
  }
  return pixmap;
}

}  // namespace cutis
