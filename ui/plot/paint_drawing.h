#pragma once  // internal to ui/plot

// A drawing of src/report painted with QPainter, and the room that its words take then. Interface
// thread only.

#include <map>
#include <utility>

#include <QFont>
#include <QFontMetricsF>

#include "src/report/text_metrics.h"

class QPainter;

namespace cutis {

// Words are set in one font; styles of other sizes are scaled from it.
class PaintFonts : public TextMetrics {
 public:
  explicit PaintFonts(const QFont& font);

  double width(std::string_view words, const TextStyle& style) const override;
  double ascent(const TextStyle& style) const override;
  double descent(const TextStyle& style) const override;

  // The size of an em of the font itself, in pixels.
  double baseSize() const { return baseSize_; }
  const QFont& font() const { return font_; }
  const QFont& fontOf(const TextStyle& style) const { return setOf(style).font; }
  const QFontMetricsF& metricsOf(const TextStyle& style) const { return setOf(style).metrics; }

 private:
  struct Set {
    QFont font;
    QFontMetricsF metrics;
  };
  const Set& setOf(const TextStyle& style) const;

  QFont font_;
  double baseSize_;
  // By size and weight; made when first asked for.
  mutable std::map<std::pair<double, bool>, Set> sets_;
};

// Lines across and upwards are as sharp as the screen allows. Leaves the painter as it was.
void paint(QPainter& painter, const Drawing& drawing, const PaintFonts& fonts);

}  // namespace cutis
