#include "ui/view/color_bar.h"

#include <algorithm>

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>

#include "ui/theme/theme.h"
#include "ui/view/range_texts.h"

namespace cutis {
namespace {

constexpr qreal kSmallestWidth = 220;
constexpr qreal kBarHeight = 12;
constexpr qreal kPadding = 10;
constexpr qreal kTickLength = 4;

QImage imageOf(const ColorScale& scale) {
  QImage image(256, 1, QImage::Format_RGB32);
  for (int i = 0; i < 256; ++i)
    image.setPixel(i, 0, scale.table()[static_cast<std::size_t>(i)]);
  return image;
}

}  // namespace

QRectF drawColorBar(QPainter& painter, const QFont& font, const QPointF& lowerLeft,
                    const ColorBarSpec& spec) {
  QFont bold = font;
  bold.setBold(true);
  const QFontMetricsF metrics(font);
  const qreal line = metrics.height();
  const qreal gap = theme::kHalfSpace;
  const qreal height = 2 * kPadding + line + gap + kBarHeight + kTickLength + gap / 2 + line;
  // Name and unit stand side by side.
  const qreal width =
      std::max(kSmallestWidth, QFontMetricsF(bold).horizontalAdvance(spec.name) +
                                   theme::kDoubleSpace + metrics.horizontalAdvance(spec.unit));
  const QRectF backdrop(lowerLeft.x(), lowerLeft.y() - height, width + 2 * kPadding, height);
  const QRectF inside = backdrop.adjusted(kPadding, kPadding, -kPadding, -kPadding);

  painter.save();
  painter.setFont(font);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0x14, 0x14, 0x14, 0xd8));
  painter.drawRoundedRect(backdrop, theme::kCornerRadius, theme::kCornerRadius);

  const QRectF title(inside.left(), inside.top(), inside.width(), line);
  painter.setPen(theme::tones().text);
  painter.setFont(bold);
  painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter, spec.name);
  painter.setFont(font);
  painter.setPen(theme::tones().dimText);
  painter.drawText(title, Qt::AlignRight | Qt::AlignVCenter, spec.unit);

  const QRectF bar(inside.left(), title.bottom() + gap, width, kBarHeight);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(bar, imageOf(ColorScale::of(spec.scale)));

  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(theme::tones().text);
  const std::array<QString, 3> texts = rangeTexts(spec.minimum, spec.maximum);
  const QRectF numbers(bar.left(), bar.bottom() + kTickLength + gap / 2, bar.width(), line);
  const Qt::Alignment sides[] = {Qt::AlignLeft, Qt::AlignHCenter, Qt::AlignRight};
  for (int i = 0; i < 3; ++i) {
    const qreal x = bar.left() + (bar.width() - 1) * i / 2;
    painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + kTickLength - 1));
    painter.drawText(numbers, static_cast<int>(sides[i] | Qt::AlignVCenter),
                     texts[static_cast<std::size_t>(i)]);
  }
  painter.restore();
  return backdrop;
}

}  // namespace cutis
