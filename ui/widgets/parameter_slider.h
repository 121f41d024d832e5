#pragma once

// One number of an edit: name, number field, and a slider with the neutral value in its middle.

#include <QWidget>

#include "ui/widgets/slider_scale.h"

class QDoubleSpinBox;
class QLabel;

namespace cutis {

class NeutralSlider;

class ParameterSlider : public QWidget {
  Q_OBJECT

 public:
  // The tool tip should say what the number does to skin. The scale has no unit: a factor.
  ParameterSlider(const QString& name, const QString& toolTip, const SliderScale& scale = {},
                  QWidget* parent = nullptr);

  double value() const;
  // Clamps to the scale; silent.
  void setValue(double value);

 Q_SIGNALS:
  // The user has changed it. While the slider is dragged stillMoving is true; the drag ends with
  // one call where it is false. Keys, double click and typed numbers are final at once.
  void valueChanged(double value, bool stillMoving);

 private:
  void showValue(double value);

  QLabel* label_;
  QDoubleSpinBox* field_;
  NeutralSlider* slider_;
};

}  // namespace cutis
