#pragma once

// A second picture of the same place beside the first, or over a part of it: how the view is shared
// between the two, and what marks the border. Interface thread only; lengths are in
// device-independent pixels unless they are said to be the device's.

#include <QPointF>
#include <QSize>
#include <QString>

#include "ui/view/picture_images.h"

class QFont;
class QPainter;

namespace cutis {

class ViewGeometry;

enum class SplitMode {
  none,        // the first picture alone
  wipe,        // the first left of a line, the second right of it
  sideBySide,  // each in a half of the view, both of the same part of the picture
  second       // the second alone, in the first one's place
};

struct PictureSplit {
  SplitMode mode = SplitMode::none;
  QString firstName, secondName;  // what the two are called where both are seen
  double position = 0.5;          // of the line, as a share of the view's width
  PictureImages second;

  bool showsFirst() const { return mode != SplitMode::second; }
  // The part of the view that one picture has.
  QSize paneOf(QSize view) const;
  // Where a point of the view lies in the pane of the first picture.
  QPointF intoFirst(const QPointF& point, int viewWidth) const;
  // The line of the wipe, from the left edge.
  double lineAt(int viewWidth) const { return position * viewWidth; }
  bool isOnLine(const QPointF& point, int viewWidth) const;
  void moveLineTo(double x, int viewWidth);

  // In device pixels of the view.
  void draw(QPainter& painter, const ViewGeometry& geometry, const PictureImages& first,
            QSize devicePixels) const;
  // The border and the names.
  void drawFrame(QPainter& painter, const QFont& font, QSize view) const;
};

}  // namespace cutis
