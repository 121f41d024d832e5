#pragma once

// A small button with a cross, to close or cancel something. Interface thread only.

#include <QToolButton>

namespace cutis {

// Draws its cross itself: fonts without the sign would show a box, and pictures blur at 1.5 ×.
class CrossButton : public QToolButton {
 public:
  CrossButton(const QString& name, const QString& toolTip, QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace cutis
