#pragma once

// The line above a plot: heading on the left, legend on the right. And the pens of its curves.

#include <vector>

#include <QPen>
#include <QRectF>
#include <QString>

class QPainter;

namespace cutis {

// The second is dashed, too: never colour alone.
QPen firstCurvePen();
QPen secondCurvePen();

struct LegendEntry {
  QString text;
  QPen pen;
  double pointRadius = 0;  // of a point on the sample of the line; 0 draws none
};

// With the painter's font; a heading that has no room is shortened. Leaves the painter as it was.
void drawPlotTitle(QPainter& painter, const QRectF& line, const QString& heading,
                   const std::vector<LegendEntry>& legend);

}  // namespace cutis
