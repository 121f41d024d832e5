#include "ui/commands/command_delegate.h"

#include <QPainter>

#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kCommandPadding = 6;

QFont smaller(QFont font) {
  font.setPointSizeF(font.pointSizeF() * 0.9);
  return font;
}

}  // namespace

QSize CommandDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  const int lines = option.fontMetrics.height() + QFontMetrics(smaller(option.font)).height();
  return {200, lines + 2 * kCommandPadding};
}

void CommandDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
  const theme::Tones& tones = theme::tones();
  const bool isCurrent = option.state & QStyle::State_Selected;
  const QString reason = index.data(reasonRole).toString();
  painter->save();
  if (isCurrent) {
    painter->fillRect(option.rect, tones.raised);
    painter->fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())), tones.accent);
  }
  const QRect inner = option.rect.adjusted(theme::kDoubleSpace, kCommandPadding,
                                           -theme::kDoubleSpace, -kCommandPadding);
  const QString shortcut = index.data(shortcutRole).toString();
  const int keysWidth = option.fontMetrics.horizontalAdvance(shortcut);
  painter->setFont(option.font);
  painter->setPen(tones.dimText);
  painter->drawText(inner, Qt::AlignRight | Qt::AlignTop, shortcut);
  const int room = inner.width() - keysWidth - theme::kDoubleSpace;
  painter->setPen(reason.isEmpty() ? tones.text : tones.dimText);
  painter->drawText(inner, Qt::AlignLeft | Qt::AlignTop,
                    option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, room));
  painter->setFont(smaller(option.font));
  painter->setPen(tones.dimText);
  const QString place = index.data(placeRole).toString();
  const QString below = reason.isEmpty() ? place : QString("%1 — %2").arg(place, reason);
  painter->drawText(inner, Qt::AlignLeft | Qt::AlignBottom,
                    painter->fontMetrics().elidedText(below, Qt::ElideRight, inner.width()));
  painter->restore();
}

}  // namespace cutis
