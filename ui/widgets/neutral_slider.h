#pragma once  // internal to ui/widgets

// A slider with its neutral value in the middle: the groove fills from there, a double click goes
// back there. A drag moves the handle by as much as the mouse moves, wherever it begins, so that a
// click alone changes nothing. Shift makes drag and keys ten times finer. The wheel acts only when
// it has the focus, so that scrolling a dock changes nothing.

#include <QSlider>

#include "ui/widgets/slider_motion.h"
#include "ui/widgets/slider_scale.h"

namespace cutis {

class NeutralSlider : public QSlider {
  Q_OBJECT

 public:
  explicit NeutralSlider(const SliderScale& scale, QWidget* parent = nullptr);

  double number() const { return number_; }
  // Silent. Another number ends a drag that is under way.
  void setNumber(double number);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  // The user has moved it. A drag ends with `done`, even where it began.
  void valueMoved(double value, cutis::SliderMotion motion);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  QRectF groove() const;
  void place(double value);
  void moveTo(double value, SliderMotion motion);

  SliderScale scale_;
  double number_;
  bool dragging_ = false;
  bool moved_ = false;    // since the mouse was pressed
  double dragX_ = 0;      // of the mouse, at its last move
  double dragPlace_ = 0;  // may lie beyond the ends: the handle waits for the mouse to come back
};

}  // namespace cutis
