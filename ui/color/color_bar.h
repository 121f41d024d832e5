#pragma once

// The labelled colour bar that lies over a false-colour picture: the field's name and unit, the
// colours from minimum to maximum, and the numbers at both ends and the middle. Where the range can
// be moved, the spread of the values stands on it, and handles mark where the range ends.

#include <optional>
#include <vector>

#include <QRectF>
#include <QString>

#include "src/app/document/pixel_marks.h"
#include "ui/color/color_scale.h"
#include "ui/color/display_range.h"

class QFont;
class QPainter;

namespace cutis {

struct ColorBarSpec {
  QString name;        // "Melanin"
  QString unit;        // "volume fraction"; may be empty
  DisplayRange range;  // in the unit
  ScaleKind scale = ScaleKind::sequential;
  QString state = {};   // "Edited"; what the numbers leave open, may be empty
  bool isKnown = true;  // false: there is nothing that numbers could stand for yet
  // Where the ends of the range can be moved: what the bar reaches over, and how the values are
  // spread there (heightsAlong()). Without it the bar is the range.
  std::optional<DisplayRange> axis = {};
  std::vector<float> heights = {};
  PixelMarks marks = 0;  // that are hatched over the picture, explained below the numbers

  bool operator==(const ColorBarSpec&) const = default;
};

// Draws with its lower left corner at the given point, on a backdrop of its own, over a picture of
// the given size. It covers a quarter of the picture at most: where that is small it leaves out the
// unit and the middle, and is left out where not even the name has room. Lengths in
// device-independent pixels. Returns what was covered.
QRectF drawColorBar(QPainter& painter, const QFont& font, const QPointF& lowerLeft,
                    const QSizeF& picture, const ColorBarSpec& spec);

// What it would cover, its upper left corner at the origin, and where the colours lie in it. Both
// are empty where it is left out.
struct ColorBarPlaces {
  QSizeF size;
  QRectF colors;
};
ColorBarPlaces placesOf(const QFont& font, const QSizeF& picture, const ColorBarSpec& spec);

}  // namespace cutis
