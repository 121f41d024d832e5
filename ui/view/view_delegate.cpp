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

void drawHeading(QPainter& painter, const QRect& cell, const QFont& font,
                 const QModelIndex& index) {
  painter.save();
  painter.setFont(font);
  painter.setPen(theme::tones().dimText);
  painter.drawText(cell.adjusted(kFrame, 0, 0, -1), Qt::AlignLeft | Qt::AlignBottom,
                   index.data().toString());
  painter.restore();
}

}  // namespace

QSize ViewDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  if (index.data(kHeadingRole).toBool())
    return {0, option.fontMetrics.height() + theme::kHalfSpace};
  return {kThumbnailSize.width() + 2 * kFrame, kThumbnailSize.height() + 2 * kFrame};
}

void ViewDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  const QFont font = option.widget ? theme::smallFont(*option.widget) : option.font;
  if (index.data(kHeadingRole).toBool()) return drawHeading(*painter, option.rect, font, index);
  const theme::Tones& tones = theme::tones();
  const bool chosen = option.state & QStyle::State_Selected;
  const bool hovered = option.state & QStyle::State_MouseOver;
  const QRect cell = option.rect;
  const QRectF plate(QPointF(cell.left() + kFrame, cell.top() + kFrame), QSizeF(kThumbnailSize));
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
  const QRectF name(plate.right() + kFrame + theme::kHalfSpace, cell.top(),
                    cell.right() - plate.right() - kFrame - theme::kHalfSpace, cell.height());
  painter->setFont(font);
  painter->setPen(chosen || hovered ? tones.text : tones.dimText);
  painter->drawText(name, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
                    index.data().toString());
  if (option.state & QStyle::State_HasFocus && option.state & QStyle::State_KeyboardFocusChange) {
    theme::drawFocusRing(*painter, QRectF(cell));
  }
  painter->restore();
}

}  // namespace cutis
