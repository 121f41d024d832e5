#pragma once  // internal to ui/view

// The labelled colour bar that lies over a false-colour picture: the field's name and unit, the
// colours from minimum to maximum, and the numbers at both ends and the middle.

#include <QString>

#include "ui/view/color_scale.h"

class QFont;
class QPainter;
class QPointF;
class QRectF;

namespace cutis {

struct ColorBarSpec {
  QString name;        // "Melanin"
  QString unit;        // "volume fraction"; may be empty
  double minimum = 0;  // in the unit
  double maximum = 1;
  ScaleKind scale = ScaleKind::sequential;

  bool operator==(const ColorBarSpec&) const = default;
};

// Draws with its lower left corner at the given point, on a backdrop of its own. Lengths in
// device-independent pixels. Returns what was covered.
QRectF drawColorBar(QPainter& painter, const QFont& font, const QPointF& lowerLeft,
                    const ColorBarSpec& spec);

}  // namespace cutis
