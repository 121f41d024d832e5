#include "ui/view/color_bar.h"

#include <algorithm>
#include <array>

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>

#include "ui/theme/theme.h"
#include "ui/view/range_texts.h"

namespace cutis {
namespace {

constexpr qreal kSmallestWidth = 220;
constexpr qreal kTickLength = 4;
constexpr qreal kLargestShare = 0.25;  // of the picture
constexpr qreal kFewestWords = 70;     // a bar that is narrower says nothing

QImage imageOf(const ColorScale& scale) {
  QImage image(256, 1, QImage::Format_RGB32);
  for (int i = 0; i < 256; ++i)
    image.setPixel(i, 0, scale.table()[static_cast<std::size_t>(i)]);
  return image;
}

// Where its parts lie, seen from the upper left corner of the backdrop.
struct Layout {
  bool isWhole = true;
  qreal padding = 10;
  qreal barHeight = 12;
  qreal line = 0;
  QSizeF size;  // of the backdrop

  QRectF row(qreal top, qreal height) const {
    return {padding, top, size.width() - 2 * padding, height};
  }
  QRectF title() const { return row(padding, line); }
  QRectF bar() const { return row(title().bottom() + theme::kHalfSpace, barHeight); }
  QRectF numbers() const { return row(bar().bottom() + kTickLength + 2, line); }
};

Layout layoutOf(const QFont& font, const QSizeF& picture, const ColorBarSpec& spec) {
  QFont bold = font;
  bold.setBold(true);
  const QFontMetricsF metrics(font);
  Layout layout;
  layout.line = metrics.height();
  // Name and unit stand side by side.
  const qreal words =
      std::max(kSmallestWidth, QFontMetricsF(bold).horizontalAdvance(spec.name) +
                                   theme::kDoubleSpace + metrics.horizontalAdvance(spec.unit));
  layout.size.setWidth(words + 2 * layout.padding);
  layout.size.setHeight(layout.numbers().bottom() + layout.padding);
  const qreal room = kLargestShare * picture.width() * picture.height();
  const bool hasRoom = layout.size.width() * layout.size.height() <= room;
  if (hasRoom && layout.size.width() <= picture.width()) return layout;
  layout.isWhole = false;
  layout.padding = 4;
  layout.barHeight = 6;
  layout.size.setHeight(layout.numbers().bottom() + layout.padding);
  layout.size.setWidth(
      std::min({layout.size.width(), room / layout.size.height(), picture.width()}));
  return layout;
}

void drawTitle(QPainter& painter, const QFont& font, const Layout& layout,
               const ColorBarSpec& spec) {
  QFont bold = font;
  bold.setBold(true);
  const QRectF title = layout.title();
  painter.setPen(theme::tones().text);
  painter.setFont(bold);
  painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetricsF(bold).elidedText(spec.name, Qt::ElideRight, title.width()));
  painter.setFont(font);
  if (!layout.isWhole) return;
  painter.setPen(theme::tones().dimText);
  painter.drawText(title, Qt::AlignRight | Qt::AlignVCenter, spec.unit);
}

// The state takes the place of the number in the middle, or of all where none is known.
void drawNumbers(QPainter& painter, const Layout& layout, const ColorBarSpec& spec) {
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(theme::tones().text);
  std::array<QString, 3> texts;
  if (spec.isKnown) texts = rangeTexts(spec.minimum, spec.maximum);
  if (!layout.isWhole || !spec.state.isEmpty()) texts[1] = spec.state;
  const QRectF bar = layout.bar();
  const Qt::Alignment sides[] = {Qt::AlignLeft, Qt::AlignHCenter, Qt::AlignRight};
  for (int i = 0; i < 3; ++i) {
    const qreal x = bar.left() + (bar.width() - 1) * i / 2;
    if (spec.isKnown)
      painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + kTickLength - 1));
    painter.drawText(layout.numbers(), static_cast<int>(sides[i] | Qt::AlignVCenter),
                     texts[static_cast<std::size_t>(i)]);
  }
}

}  // namespace

QRectF drawColorBar(QPainter& painter, const QFont& font, const QPointF& lowerLeft,
                    const QSizeF& picture, const ColorBarSpec& spec) {
  const Layout layout = layoutOf(font, picture, spec);
  if (layout.size.width() < kFewestWords) return {};
  const QPointF corner = lowerLeft - QPointF(0, layout.size.height());
  painter.save();
  painter.translate(corner);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0x14, 0x14, 0x14, 0xd8));
  painter.drawRoundedRect(QRectF({}, layout.size), theme::kCornerRadius, theme::kCornerRadius);
  drawTitle(painter, font, layout, spec);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (spec.isKnown) painter.drawImage(layout.bar(), imageOf(ColorScale::of(spec.scale)));
  drawNumbers(painter, layout, spec);
  painter.restore();
  return {corner, layout.size};
}

}  // namespace cutis
