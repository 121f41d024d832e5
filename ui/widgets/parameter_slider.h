#pragma once

// One number of an edit: its name, and below that a slider with the neutral value in its middle and
// a field with the number. A right click offers to reset, copy and enter it.

#include <QTimer>
#include <QWidget>

#include "ui/widgets/slider_motion.h"
#include "ui/widgets/slider_scale.h"

class QLabel;
class QShortcut;

namespace cutis {

class FactorField;
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
  // A number that was refused is forgotten.
  void dropEntry();
  bool isEntryRefused() const;
  // Why it cannot be moved now, which its tool tip says; empty if it can.
  void setResting(const QString& why);

 Q_SIGNALS:
  // The user has changed it. While the slider is dragged stillMoving is true; the drag ends with
  // one call where it is false.
  void valueChanged(double value, bool stillMoving);
  // What has changed since the last one is one step: a drag, a typed number, or keys and notches
  // of the wheel that came without a pause.
  void stepEnded();
  // A number was refused, or that is over.
  void entryRefused();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void layOut();
  void change(double value, SliderMotion motion);
  void endBurst();
  void enterValue();

  SliderScale scale_;
  QString usualToolTip_;
  QLabel* label_;
  NeutralSlider* slider_;
  FactorField* field_;
  QLabel* message_;
  QTimer burst_;
  QShortcut* escape_;  // wherever the keyboard is, while a number is refused
};

}  // namespace cutis
