#pragma once

// Exposure and gamma of the view, with a way back that is marked while they are not neutral.
// Interface thread only.

#include <QWidget>

#include "ui/color/display_curve.h"

class QDoubleSpinBox;
class QToolButton;

namespace cutis {

class AdjustmentBar : public QWidget {
  Q_OBJECT

 public:
  explicit AdjustmentBar(QWidget* parent = nullptr);

  // Silent.
  void setAdjustment(const ViewAdjustment& adjustment);
  ViewAdjustment adjustment() const;

 Q_SIGNALS:
  // The user has chosen it.
  void chosen(const cutis::ViewAdjustment& adjustment);

 private:
  void choose();
  void mark();

  QDoubleSpinBox* stops_;
  QDoubleSpinBox* gamma_;
  QToolButton* reset_;
};

}  // namespace cutis
