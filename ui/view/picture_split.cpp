#include "ui/view/picture_split.h"

#include <algorithm>
#include <cmath>

#include <QFontMetrics>
#include <QPainter>

#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr double kLineReach = 6;  // of the line for a mouse, to either side
constexpr double kGrip = 9;       // half the height of the grip
const QColor kShade(0x14, 0x14, 0x14, 0xd8);

// Light beside dark, so that it is seen on any picture.
void drawLine(QPainter& painter, double x, int height) {
  painter.fillRect(QRectF(x - 1.5, 0, 3, height), kShade);
  painter.fillRect(QRectF(x - 0.5, 0, 1, height), theme::tones().text);
}

void drawGrip(QPainter& painter, double x, int height) {
  const QPointF middle(x, height / 2.0);
  painter.setPen(QPen(theme::tones().text, 1));
  painter.setBrush(kShade);
  painter.drawRoundedRect(QRectF(middle.x() - 5, middle.y() - kGrip, 10, 2 * kGrip), 4, 4);
  for (const double dx : {-1.5, 1.5})
    painter.drawLine(middle + QPointF(dx, -4), middle + QPointF(dx, 4));
}

// Shortened to the room that there is between two edges, beside one of them.
void drawName(QPainter& painter, const QFontMetrics& metrics, const QString& name, double left,
              double right, bool atLeft) {
  const int room = static_cast<int>(right - left) - 2 * theme::kDoubleSpace - theme::kDoubleSpace;
  const QString text = metrics.elidedText(name, Qt::ElideRight, room);
  if (room < metrics.averageCharWidth() * 3 || text.isEmpty()) return;
  QRectF box(QPointF(), QSizeF(metrics.size(0, text)) + QSizeF(theme::kDoubleSpace, theme::kSpace));
  box.moveTop(theme::kSpace);
  atLeft ? box.moveLeft(left + theme::kSpace) : box.moveRight(right - theme::kSpace);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kShade);
  painter.drawRoundedRect(box, theme::kCornerRadius, theme::kCornerRadius);
  painter.setPen(theme::tones().text);
  painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace

QSize PictureSplit::paneOf(QSize view) const {
  return mode == SplitMode::sideBySide ? QSize(view.width() / 2, view.height()) : view;
}

QPointF PictureSplit::intoFirst(const QPointF& point, int viewWidth) const {
  const int half = viewWidth / 2;
  const bool isBeyond = mode == SplitMode::sideBySide && point.x() >= half;
  return isBeyond ? point - QPointF(half, 0) : point;
}

bool PictureSplit::isOnLine(const QPointF& point, int viewWidth) const {
  return mode == SplitMode::wipe && std::abs(point.x() - lineAt(viewWidth)) <= kLineReach;
}

void PictureSplit::moveLineTo(double x, int viewWidth) {
  if (viewWidth > 0) position = std::clamp(x / viewWidth, 0.0, 1.0);
}

void PictureSplit::draw(QPainter& painter, const ViewGeometry& geometry, const PictureImages& first,
                        QSize devicePixels) const {
  const int width = devicePixels.width(), height = devicePixels.height();
  const int line = static_cast<int>(std::lround(position * width));
  switch (mode) {
    case SplitMode::none:
      return first.draw(painter, geometry, QRect(QPoint(), devicePixels));
    case SplitMode::second:
      return second.draw(painter, geometry, QRect(QPoint(), devicePixels));
    case SplitMode::wipe:
      first.draw(painter, geometry, QRect(0, 0, line, height));
      return second.draw(painter, geometry, QRect(line, 0, width - line, height));
    case SplitMode::sideBySide: {
      const QRect pane(QPoint(), paneOf(devicePixels));
      first.draw(painter, geometry, pane);
      painter.translate(pane.width(), 0);
      second.draw(painter, geometry, pane);
      painter.translate(-pane.width(), 0);
      return;
    }
  }
}

void PictureSplit::drawFrame(QPainter& painter, const QFont& font, QSize view) const {
  if (mode == SplitMode::none) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font);
  const QFontMetrics metrics(font);
  const double right = view.width();
  if (mode == SplitMode::second) return drawName(painter, metrics, secondName, 0, right, true);
  const double border = mode == SplitMode::wipe ? lineAt(view.width()) : view.width() / 2;
  drawLine(painter, border, view.height());
  if (mode == SplitMode::wipe) drawGrip(painter, border, view.height());
  drawName(painter, metrics, firstName, 0, border, true);
  drawName(painter, metrics, secondName, border, right, false);
}

}  // namespace cutis
