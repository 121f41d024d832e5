#include "ui/widgets/parameter_slider.h"

#include <algorithm>
#include <optional>

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QSignalBlocker>

#include "ui/theme/theme.h"
#include "ui/widgets/neutral_slider.h"

namespace cutis {
namespace {

// A number beyond the range is taken as the nearest end; Qt would put the old one back without a
// word. Shift and the arrow keys step ten times finer here too; Qt's own modifier is control, and
// coarser.
class FactorField : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;

  void stepBy(int steps) override {
    const bool fine = QGuiApplication::keyboardModifiers() & Qt::ShiftModifier;
    setValue(value() + steps * singleStep() * (fine ? 0.1 : 1.0));
  }

  // Any number may be typed, with more digits than are kept or a sign.
  QValidator::State validate(QString& text, int& position) const override {
    const QValidator::State state = QDoubleSpinBox::validate(text, position);
    if (state != QValidator::Invalid) return state;
    const bool isBegun = text == "-" || text == "+" || numberIn(text).has_value();
    return isBegun ? QValidator::Intermediate : state;
  }

  void fixup(QString& text) const override {
    const std::optional<double> number = numberIn(text);
    text = textFromValue(number ? std::clamp(*number, minimum(), maximum()) : value());
  }

 private:
  std::optional<double> numberIn(const QString& text) const {
    bool isNumber = false;
    const double number = locale().toDouble(text, &isNumber);
    return isNumber ? std::optional(number) : std::nullopt;
  }
};

}  // namespace

ParameterSlider::ParameterSlider(const QString& name, const QString& toolTip,
                                 const SliderScale& scale, QWidget* parent)
    : QWidget(parent),
      label_(new QLabel(name, this)),
      field_(new FactorField(this)),
      slider_(new NeutralSlider(scale, this)) {
  field_->setRange(scale.minimum, scale.maximum);
  field_->setDecimals(3);
  field_->setSingleStep(0.05);
  field_->setKeyboardTracking(false);  // "1.25" is one change, not four
  field_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field_->setAlignment(Qt::AlignRight);
  field_->setAccessibleName(tr("%1, number").arg(name));
  field_->setToolTip(tr("From %1 to %2").arg(scale.minimum).arg(scale.maximum));
  field_->setFixedWidth(field_->fontMetrics().horizontalAdvance("0.0000") + 2 * theme::kSpace);
  slider_->setAccessibleName(name);
  label_->setBuddy(field_);
  setAccessibleName(name);
  setToolTip(toolTip);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(theme::kHalfSpace / 2);
  grid->addWidget(label_, 0, 0);
  grid->addWidget(field_, 0, 1);
  grid->addWidget(slider_, 1, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  setFocusProxy(slider_);
  showValue(scale.neutral);

  connect(slider_, &NeutralSlider::valueMoved, this, [this](double value, bool stillMoving) {
    showValue(value);
    Q_EMIT valueChanged(value, stillMoving);
  });
  connect(field_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    slider_->setNumber(value);
    Q_EMIT valueChanged(value, false);
  });
}

double ParameterSlider::value() const {
  return slider_->number();
}

void ParameterSlider::setValue(double value) {
  slider_->setNumber(value);
  showValue(slider_->number());
}

void ParameterSlider::showValue(double value) {
  const QSignalBlocker silent(field_);
  field_->setValue(value);
}

}  // namespace cutis
