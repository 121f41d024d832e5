#pragma once  // internal to ui/view

// Markers of places in the picture: a ring with a letter beside it, in the colour of the place's
// curve; of a square of pixels its outline, too, where it is large enough to be seen.
//
// Places are in image pixels, lengths in device-independent ones. Interface thread only.

#include <functional>
#include <optional>

#include <QColor>
#include <QPoint>
#include <QPointF>
#include <QString>
#include <QVector>

class QFont;
class QPainter;

namespace cutis {

struct PictureMarker {
  QPoint pixel;
  QString letter;
  QString name;  // may be empty
  QColor color;
  int size = 1;  // side of the square about the pixel
  bool isSelected = false;

  bool operator==(const PictureMarker&) const = default;
};

// From image points to the widget's.
using ToWidget = std::function<QPointF(const QPointF& image)>;

void drawMarkers(QPainter& painter, const QFont& font, const QVector<PictureMarker>& markers,
                 const ToWidget& toWidget);
// The marker at a point of the widget; of several the one that is drawn last.
std::optional<int> markerAt(const QVector<PictureMarker>& markers, const QPointF& point,
                            const ToWidget& toWidget);

}  // namespace cutis
