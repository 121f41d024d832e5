#pragma once  // internal to ui/widgets

// A slider with its neutral value in the middle: the groove fills from there, a double click goes
// back there. Shift makes drag and keys ten times finer. The wheel acts only when it has the focus,
// so that scrolling a dock changes nothing.

#include <QSlider>

#include "ui/widgets/slider_scale.h"

namespace cutis {

class NeutralSlider : public QSlider {
  Q_OBJECT

 public:
  explicit NeutralSlider(const SliderScale& scale, QWidget* parent = nullptr);

  double number() const { return number_; }
  // Silent.
  void setNumber(double number);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  // The user has moved it. A drag ends with stillMoving false, even where it began.
  void valueMoved(double value, bool stillMoving);

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
  void moveTo(double value, bool stillMoving);

  SliderScale scale_;
  double number_;
  bool dragging_ = false;
  double dragX_ = 0;      // of the mouse, at its last move
  double dragPlace_ = 0;  // may lie beyond the ends: the handle waits for the mouse to come back
};

}  // namespace cutis
