#include "ui/widgets/exposure_control.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>

#include "ui/theme/theme.h"
#include "ui/widgets/factor_field.h"
#include "ui/widgets/factor_text.h"

namespace cutis {
namespace {

constexpr SliderScale kExposures = {0.001, 1.0, 1000.0};

}  // namespace

ExposureControl::ExposureControl(QWidget* parent)
    : QWidget(parent),
      field_(new FactorField(kExposures, this)),
      automatic_(new QCheckBox(tr("Automatic"), this)),
      reason_(new QLabel(this)),
      message_(new QLabel(this)) {
  field_->setAccessibleName(tr("Exposure"));
  field_->setAccessibleDescription(limitsText(kExposures));
  field_->setToolTip(tr("Multiplies the light of the picture before it is fitted. From %1")
                         .arg(limitsText(kExposures)));
  automatic_->setToolTip(
      tr("1, unless another factor brings much more of the picture into the range of skin"));
  reason_->setAccessibleName(tr("Why this exposure"));
  setFocusProxy(field_);
  layOut();
  connect(field_, &FactorField::numberTyped, this, &ExposureControl::chosen);
  connect(field_, &FactorField::numberStepped, this, &ExposureControl::chosen);
  connect(field_, &FactorField::refused, this, [this](const QString& sentence) {
    message_->setText(sentence);
    message_->setVisible(!sentence.isEmpty());
  });
  connect(automatic_, &QCheckBox::clicked, this, [this](bool isAutomatic) {
    if (isAutomatic) {
      Q_EMIT automaticWanted();
    } else {
      Q_EMIT chosen(field_->number());
    }
  });
}

void ExposureControl::layOut() {
  theme::dimText(*reason_);
  QPalette alarmed = message_->palette();
  alarmed.setColor(QPalette::WindowText, theme::tones().error);
  message_->setPalette(alarmed);
  for (QLabel* label : {reason_, message_})
    label->setWordWrap(true);
  message_->hide();
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(theme::kSpace);
  grid->setVerticalSpacing(theme::kHalfSpace);
  grid->addWidget(field_, 0, 0);
  grid->addWidget(automatic_, 0, 1);
  grid->addWidget(reason_, 1, 0, 1, 2);
  grid->addWidget(message_, 2, 0, 1, 2);
  grid->setColumnStretch(1, 1);
}

void ExposureControl::show(double exposure, bool isAutomatic,
                           const std::optional<double>& shareInRange) {
  field_->setNumber(exposure);
  automatic_->setChecked(isAutomatic);
  if (!isAutomatic) {
    reason_->setText(tr("Chosen by you"));
  } else if (shareInRange) {
    reason_->setText(tr("Found: %1 % of the pixels are in the range of skin colours")
                         .arg(100.0 * *shareInRange, 0, 'f', 0));
  } else {
    reason_->setText(tr("Found by the fit"));
  }
}

}  // namespace cutis
