#include "ui/widgets/cross_button.h"

#include <QPainter>

#include "ui/theme/theme.h"

namespace cutis {

CrossButton::CrossButton(const QString& name, const QString& toolTip, QWidget* parent)
    : QToolButton(parent) {
  setAutoRaise(true);
  setAccessibleName(name);
  setToolTip(toolTip);
  setFocusPolicy(Qt::TabFocus);
  setFixedSize(24, 24);
}

void CrossButton::paintEvent(QPaintEvent* event) {
  QToolButton::paintEvent(event);
  constexpr double kArm = 4;
  const QPointF middle = QRectF(rect()).center();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme::tones().text, 1.6, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(middle - QPointF(kArm, kArm), middle + QPointF(kArm, kArm));
  painter.drawLine(middle - QPointF(kArm, -kArm), middle + QPointF(kArm, -kArm));
  if (hasFocus()) theme::drawFocusRing(painter, QRectF(rect()));
}

}  // namespace cutis
