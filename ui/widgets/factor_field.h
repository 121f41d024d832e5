#pragma once  // internal to ui/widgets

// A field for a factor. What is typed becomes the factor with Return or when the field is left;
// what cannot be one stays as it was typed, is marked and explained, until it is corrected or Esc
// in the field, or dropEntry(), brings the factor back. The arrow keys step, ten times finer with
// shift.
//
// Undo belongs to the text while that differs from the factor, else to the document.

#include <QLineEdit>

#include "ui/widgets/slider_scale.h"

namespace cutis {

class FactorField : public QLineEdit {
  Q_OBJECT

 public:
  explicit FactorField(const SliderScale& scale, QWidget* parent = nullptr);

  double number() const { return number_; }
  // Silent. A text that is being typed, or was refused, gives way only to another number.
  void setNumber(double number);
  // What was typed and not taken gives way to the number. Silent.
  void dropEntry() { showNumber(); }
  bool isRefused() const { return isRefused_; }

 Q_SIGNALS:
  void numberTyped(double number);
  void numberStepped(double number);
  // Why what was typed cannot be taken; empty when that is over.
  void refused(const QString& sentence);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  bool isBeingEdited() const;
  void take();
  void showNumber();
  void setRefused(const QString& sentence);
  void step(double steps);

  SliderScale scale_;
  double number_;
  bool isRefused_ = false;
  bool selectOnRelease_ = false;  // the click that brought the keyboard selects the number
};

}  // namespace cutis
