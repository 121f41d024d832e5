#pragma once

// The colour bar over the picture, whose range can be drawn to other values where its
// specification has an axis: by its two handles, or by the arrow keys (up and down choose the
// handle, Shift makes fine steps). A double click, or Home, goes back to the automatic range.
// Interface thread only.

#include <optional>

#include <QWidget>

#include "ui/color/color_bar.h"

namespace cutis {

class ColorBarControl : public QWidget {
  Q_OBJECT

 public:
  explicit ColorBarControl(QWidget* parent);

  // Nothing hides it.
  void setSpec(const std::optional<ColorBarSpec>& spec);
  const std::optional<ColorBarSpec>& spec() const { return spec_; }
  // Its lower left corner, and the size of the picture that it may cover a part of; both in the
  // parent's coordinates.
  void setPlace(const QPointF& lowerLeft, const QSizeF& picture);
  // Where a handle is, in its own coordinates.
  QPointF handleAt(bool isMaximum) const;

 Q_SIGNALS:
  void rangeMoved(const cutis::DisplayRange& range);
  void automaticWanted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  bool canBeMoved() const { return spec_ && spec_->axis && spec_->isKnown; }
  void layOut();
  // The handle goes to a position along the axis, as far as the other one leaves room.
  void moveHandle(double position);
  double handlePosition(bool isMaximum) const;

  std::optional<ColorBarSpec> spec_;
  QPointF lowerLeft_;
  QSizeF picture_;
  ColorBarPlaces places_;
  bool isMaximum_ = true;  // the handle that the keyboard moves, or the mouse has last moved
  bool isHeld_ = false;
  // While a handle is held the axis stays as it was, or it would run away from under the mouse.
  std::optional<DisplayRange> heldAxis_;
  bool showFocus_ = false;
};

}  // namespace cutis
