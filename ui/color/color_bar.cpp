#include "ui/color/color_bar.h"

#include <algorithm>
#include <array>
#include <bit>

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QPolygonF>

#include "ui/color/hatch_pattern.h"
#include "ui/color/range_texts.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr qreal kSmallestWidth = 220;
constexpr qreal kTickLength = 4;
constexpr qreal kLargestShare = 0.25;  // of the picture
constexpr qreal kFewestWords = 70;     // a bar that is narrower says nothing

constexpr qreal kHeightsHeight = 28;
constexpr qreal kHandleWidth = 9;

// What the bar reaches over.
const DisplayRange& axisOf(const ColorBarSpec& spec) {
  return spec.axis ? *spec.axis : spec.range;
}

QImage imageOf(const ColorBarSpec& spec) {
  const ColorScale& scale = ColorScale::of(spec.scale);
  const PositionIn position(spec.range);
  QImage image(256, 1, QImage::Format_RGB32);
  for (int i = 0; i < 256; ++i)
    image.setPixel(i, 0, scale.at(position(valueAt(axisOf(spec), i / 255.0)), 0.0, 1.0));
  return image;
}

// Where its parts lie, seen from the upper left corner of the backdrop.
struct Layout {
  bool isWhole = true;
  qreal heights = 0;  // of the spread of values
  qreal padding = 10;
  qreal barHeight = 12;
  qreal line = 0;
  QSizeF size;  // of the backdrop

  QRectF row(qreal top, qreal height) const {
    return {padding, top, size.width() - 2 * padding, height};
  }
  QRectF title() const { return row(padding, line); }
  QRectF spread() const { return row(title().bottom() + theme::kHalfSpace, heights); }
  QRectF bar() const { return row(spread().bottom(), barHeight); }
  QRectF numbers() const { return row(bar().bottom() + kTickLength + 2, line); }
  QRectF legend(int index) const {
    return row(numbers().bottom() + theme::kHalfSpace + index * (line + 2), line);
  }
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
  if (!spec.heights.empty()) layout.heights = kHeightsHeight;
  const int marks = std::popcount(spec.marks);
  const QRectF last = marks > 0 ? layout.legend(marks - 1) : layout.numbers();
  layout.size.setHeight(last.bottom() + layout.padding);
  const qreal room = kLargestShare * picture.width() * picture.height();
  const bool hasRoom = layout.size.width() * layout.size.height() <= room;
  if (hasRoom && layout.size.width() <= picture.width()) return layout;
  layout.isWhole = false;
  layout.heights = 0;
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
  if (spec.isKnown) texts = rangeTexts(spec.range);
  if (!layout.isWhole || spec.axis || !spec.state.isEmpty()) texts[1] = spec.state;
  const QRectF bar = layout.bar();
  const Qt::Alignment sides[] = {Qt::AlignLeft, Qt::AlignHCenter, Qt::AlignRight};
  for (int i = 0; i < 3; ++i) {
    const qreal x = bar.left() + (bar.width() - 1) * i / 2;
    if (spec.isKnown && !spec.axis)
      painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + kTickLength - 1));
    painter.drawText(layout.numbers(), static_cast<int>(sides[i] | Qt::AlignVCenter),
                     texts[static_cast<std::size_t>(i)]);
  }
}

void drawLegend(QPainter& painter, const Layout& layout, const ColorBarSpec& spec) {
  int index = 0;
  for (const PixelMark mark : kPixelMarks) {
    if ((spec.marks & mark) == 0) continue;
    const QRectF line = layout.legend(index++);
    const QRectF swatch(line.left(), line.top() + 1, 2 * line.height(), line.height() - 2);
    painter.fillRect(swatch, QColor(0x60, 0x60, 0x60));
    drawHatchSample(painter, swatch, mark);
    painter.setPen(theme::tones().text);
    painter.drawText(line.adjusted(swatch.width() + theme::kSpace, 0, 0, 0),
                     Qt::AlignLeft | Qt::AlignVCenter, markText(mark));
  }
}

// In the colours that the values have in the picture.
void drawSpread(QPainter& painter, const Layout& layout, const ColorBarSpec& spec) {
  const QRectF spread = layout.spread();
  const PositionIn position(spec.range);
  const auto count = static_cast<qreal>(spec.heights.size());
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (std::size_t i = 0; i < spec.heights.size(); ++i) {
    const double middle = (static_cast<qreal>(i) + 0.5) / count;
    QRectF column(0, 0, spread.width() / count, spread.height() * double{spec.heights[i]});
    column.moveBottomLeft(
        {spread.left() + static_cast<qreal>(i) * column.width(), spread.bottom()});
    painter.fillRect(
        column, ColorScale::of(spec.scale).at(position(valueAt(axisOf(spec), middle)), 0.0, 1.0));
  }
  painter.setRenderHint(QPainter::Antialiasing);
}

// Below the bar, each with its tip where the range ends.
void drawHandles(QPainter& painter, const Layout& layout, const ColorBarSpec& spec) {
  const PositionIn position(axisOf(spec));
  const QRectF bar = layout.bar();
  painter.setBrush(theme::tones().text);
  painter.setPen(QPen(QColor(0x14, 0x14, 0x14), 1));
  for (const double end : {spec.range.minimum, spec.range.maximum}) {
    const QPointF tip(bar.left() + position(end) * bar.width(), bar.bottom() - bar.height() / 3);
    const qreal bottom = bar.bottom() + kTickLength + 1;
    painter.drawPolygon(QPolygonF({tip, QPointF(tip.x() + kHandleWidth / 2, bottom),
                                   QPointF(tip.x() - kHandleWidth / 2, bottom)}));
  }
}

}  // namespace

ColorBarPlaces placesOf(const QFont& font, const QSizeF& picture, const ColorBarSpec& spec) {
  const Layout layout = layoutOf(font, picture, spec);
  if (layout.size.width() < kFewestWords) return {};
  return {layout.size, layout.bar().united(layout.spread())};
}

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
  if (layout.heights > 0) drawSpread(painter, layout, spec);
  if (spec.isKnown) painter.drawImage(layout.bar(), imageOf(spec));
  if (spec.isKnown && spec.axis) drawHandles(painter, layout, spec);
  drawNumbers(painter, layout, spec);
  if (layout.isWhole) drawLegend(painter, layout, spec);
  painter.restore();
  return {corner, layout.size};
}

}  // namespace cutis
