#include "ui/view/adjustment_bar.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/theme/theme.h"

namespace cutis {
namespace {

QDoubleSpinBox* fieldOf(const QString& name, double least, double most, double step) {
  auto* field = new QDoubleSpinBox;
  field->setAccessibleName(name);
  field->setRange(least, most);
  field->setSingleStep(step);
  field->setDecimals(2);
  field->setKeyboardTracking(false);
  return field;
}

}  // namespace

AdjustmentBar::AdjustmentBar(QWidget* parent)
    : QWidget(parent),
      stops_(fieldOf(tr("Exposure of the view, in stops"), -ViewAdjustment::kMostStops,
                     ViewAdjustment::kMostStops, 0.25)),
      gamma_(fieldOf(tr("Gamma of the view"), ViewAdjustment::kLeastGamma,
                     ViewAdjustment::kMostGamma, 0.1)),
      reset_(new QToolButton(this)) {
  stops_->setToolTip(
      tr("Exposure of the view in stops. It changes what you see, not what is exported."));
  gamma_->setToolTip(
      tr("Gamma of the view; above 1 the dark parts are lifted. It changes what you see, not what "
         "is exported."));
  reset_->setText(tr("Reset"));
  reset_->setToolTip(tr("Back to exposure 0 and gamma 1"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(theme::kHalfSpace);
  for (const auto& [text, field] :
       {std::pair{tr("View exp."), stops_}, std::pair{tr("γ"), gamma_}}) {
    auto* label = new QLabel(text, this);
    label->setBuddy(field);
    row->addWidget(label);
    row->addWidget(field);
    connect(field, &QDoubleSpinBox::valueChanged, this, &AdjustmentBar::choose);
  }
  row->addWidget(reset_);
  connect(reset_, &QToolButton::clicked, this, [this] {
    setAdjustment({});
    choose();
  });
  setAdjustment({});
}

void AdjustmentBar::setAdjustment(const ViewAdjustment& adjustment) {
  const QSignalBlocker stops(stops_), gamma(gamma_);
  stops_->setValue(adjustment.stops);
  gamma_->setValue(adjustment.gamma);
  mark();
}

ViewAdjustment AdjustmentBar::adjustment() const {
  return {stops_->value(), gamma_->value()};
}

void AdjustmentBar::choose() {
  mark();
  Q_EMIT chosen(adjustment());
}

// What is seen is not what is exported.
void AdjustmentBar::mark() {
  const bool isNeutral = adjustment().isNeutral();
  reset_->setEnabled(!isNeutral);
  for (QLabel* label : findChildren<QLabel*>()) {
    QPalette palette = label->palette();
    palette.setColor(QPalette::WindowText,
                     isNeutral ? theme::tones().dimText : theme::tones().accent);
    label->setPalette(palette);
  }
}

}  // namespace cutis
