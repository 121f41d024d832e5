#include "ui/view/view_delegate.h"

#include <QImage>
#include <QPainter>

#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kFrame = 3;  // room for the mark of the chosen view

void drawPlaceholder(QPainter& painter, const QRectF& plate) {
  painter.setPen(QPen(theme::tones().line, 1));
  painter.setClipRect(plate);
  constexpr double kApart = 9;
  for (double x = plate.left() - plate.height(); x < plate.right(); x += kApart) {
    painter.drawLine(QPointF(x, plate.bottom()), QPointF(x + plate.height(), plate.top()));
  }
  painter.setClipping(false);
}

}  // namespace

QSize ViewDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  return {kThumbnailSize.width() + 2 * kFrame,
          kThumbnailSize.height() + 2 * kFrame + option.fontMetrics.height() + theme::kSpace};
}

void ViewDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  const theme::Tones& tones = theme::tones();
  const bool chosen = option.state & QStyle::State_Selected;
  const bool hovered = option.state & QStyle::State_MouseOver;
  const QRect cell = option.rect;
  const QRectF plate(
      QPointF(cell.center().x() + 0.5 - kThumbnailSize.width() / 2.0, cell.top() + kFrame),
      QSizeF(kThumbnailSize));
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->fillRect(plate, tones.field);

  const QImage image = index.data(kThumbnailRole).value<QImage>();
  if (image.isNull()) {
    drawPlaceholder(*painter, plate);
  } else {
    QRectF place({}, QSizeF(image.size()).scaled(plate.size(), Qt::KeepAspectRatio));
    place.moveCenter(plate.center());
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    painter->drawImage(place, image);
  }

  // Shape beside colour: the chosen view has a frame.
  if (chosen || hovered) {
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(chosen ? tones.accent : tones.line, chosen ? 2 : 1));
    painter->drawRect(plate.adjusted(-1, -1, 1, 1));
  }
  const QFont font = option.widget ? theme::smallFont(*option.widget) : option.font;
  const QRectF name(cell.left(), plate.bottom() + kFrame + 1, cell.width(),
                    option.fontMetrics.height() + 2);
  painter->setFont(font);
  painter->setPen(chosen || hovered ? tones.text : tones.dimText);
  painter->drawText(
      name, Qt::AlignCenter,
      QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideRight, cell.width()));
  if (option.state & QStyle::State_HasFocus && option.state & QStyle::State_KeyboardFocusChange) {
    theme::drawFocusRing(*painter, QRectF(cell));
  }
  painter->restore();
}

}  // namespace cutis
