#include "ui/widgets/factor_field.h"

#include <algorithm>
#include <utility>

#include <QKeyEvent>
#include <QStyle>

#include "ui/theme/theme.h"
#include "ui/widgets/factor_text.h"
#include "ui/widgets/slider_motion.h"

namespace cutis {
FactorField::FactorField(const SliderScale& scale, QWidget* parent)
    : QLineEdit(parent), scale_(scale), number_(scale.neutral) {
  setAlignment(Qt::AlignRight);
  setFixedWidth(fontMetrics().horizontalAdvance("×0.0000") + 2 * theme::kSpace);
  showNumber();
  connect(this, &QLineEdit::textEdited, this, [this] { setRefused({}); });
}

void FactorField::setNumber(double number) {
  if (number == number_) return;
  number_ = number;
  showNumber();
}

void FactorField::showNumber() {
  setText(factorText(number_));
  setRefused({});
}

bool FactorField::isBeingEdited() const {
  return text() != factorText(number_);
}

// The style sheet draws the mark.
void FactorField::setRefused(const QString& sentence) {
  if (sentence.isEmpty() && !isRefused_) return;
  isRefused_ = !sentence.isEmpty();
  setProperty("refused", isRefused_);
  style()->unpolish(this);
  style()->polish(this);
  Q_EMIT refused(sentence);
}

void FactorField::take() {
  if (!isBeingEdited()) return;
  const ReadFactor read = readFactor(text(), scale_);
  if (!read.objection.isEmpty()) return setRefused(read.objection);
  const bool isAnother = read.factor != number_;
  number_ = read.factor;
  showNumber();
  if (isAnother) Q_EMIT numberTyped(number_);
}

void FactorField::step(double steps) {
  if (isBeingEdited()) take();
  if (isRefused_) return;
  const double stepped = std::clamp(number_ + steps * kSliderStep, scale_.minimum, scale_.maximum);
  if (stepped == number_) return;
  number_ = stepped;
  showNumber();
  Q_EMIT numberStepped(number_);
}

bool FactorField::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QLineEdit::event(event);
  auto* key = static_cast<QKeyEvent*>(event);
  const bool isUndo = key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo);
  const bool isLetter = key->key() >= Qt::Key_A && key->key() <= Qt::Key_Z &&
                        !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
  // A number that nobody is typing leaves undo and the letters to the commands.
  if ((isUndo || isLetter) && !isBeingEdited()) {
    event->ignore();
    return true;
  }
  if (key->key() == Qt::Key_Escape && isBeingEdited()) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

void FactorField::keyPressEvent(QKeyEvent* event) {
  const double fineness = event->modifiers() & Qt::ShiftModifier ? kFineStep : 1.0;
  switch (event->key()) {
    case Qt::Key_Up:
      return step(fineness);
    case Qt::Key_Down:
      return step(-fineness);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      take();
      return isRefused_ ? void() : selectAll();
    case Qt::Key_Escape:
      if (!isBeingEdited()) break;
      showNumber();
      return selectAll();
    default:
      break;
  }
  QLineEdit::keyPressEvent(event);
}

void FactorField::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  if (event->reason() == Qt::PopupFocusReason || isRefused_) return;
  selectOnRelease_ = event->reason() == Qt::MouseFocusReason;
  selectAll();
}

// A press places the cursor; what has been dragged over stays selected.
void FactorField::mouseReleaseEvent(QMouseEvent* event) {
  QLineEdit::mouseReleaseEvent(event);
  if (std::exchange(selectOnRelease_, false) && !hasSelectedText()) selectAll();
}

void FactorField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  if (event->reason() != Qt::PopupFocusReason) take();
}

}  // namespace cutis
