#include "ui/docks/edit_panel.h"

#include <algorithm>

#include <QCheckBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>

#include "ui/theme/theme.h"
#include "ui/widgets/parameter_slider.h"
#include "ui/widgets/parameter_texts.h"

namespace cutis {
namespace {

constexpr double kNeutral = 1;

}  // namespace

EditPanel::EditPanel(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Edit"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(theme::kHalfSpace);
  // The keyboard goes through the panel in the order in which its parts are made.
  addSliders();
  addFoot();
}

void EditPanel::addSliders() {
  static_assert(kParameterCount == 5, "a sixth has its slider here");
  addSlider(kMelanin,
            tr("Pigment of the upper skin. More tans and darkens, and strengthens freckles and "
               "moles; less makes the skin paler."));
  addSlider(kMelaninBlend,
            tr("Which melanin it is. More is brown-black eumelanin; less is reddish-yellow "
               "pheomelanin, as in fair and freckled skin."));
  addSlider(kCarotene,
            tr("Yellow pigment from food. More gives the skin a warm, golden cast; much more "
               "looks like carotenaemia."));
  addSlider(kHaemoglobinDermal,
            tr("Blood in the deeper skin. More flushes cheeks, nose and lips; less drains the "
               "colour from the face."));
  addSlider(kHaemoglobinEpidermal,
            tr("Blood close to the surface. More reddens blemishes and irritated skin; less "
               "calms them."));
}

void EditPanel::addFoot() {
  link_ = new QCheckBox(tr("Link haemoglobins"), this);
  link_->setChecked(true);
  link_->setToolTip(tr("Move both haemoglobins together, as a flush does"));
  presets_ = new QPushButton(tr("Presets"), this);
  presets_->setToolTip(tr("Whole sets of edits in one step; this can be undone"));
  presets_->setProperty("menu", true);
  presets_->hide();
  reset_ = new QPushButton(tr("Reset"), this);
  reset_->setToolTip(tr("Back to the skin as it was photographed; this can be undone"));
  reset_->setEnabled(false);

  layout()->addWidget(link_);
  auto* foot = new QHBoxLayout;
  foot->addWidget(presets_);
  foot->addStretch(1);
  foot->addWidget(reset_);
  static_cast<QVBoxLayout*>(layout())->addLayout(foot);

  connect(link_, &QCheckBox::toggled, this, &EditPanel::linkToggled);
  connect(reset_, &QPushButton::clicked, this, [this] {
    // Not left to the order of the panel, which would scroll it to its top.
    link_->setFocus();
    for (ParameterSlider* slider : sliders_)
      slider->dropEntry();
    Q_EMIT resetWanted();
  });
}

void EditPanel::addSlider(Parameter parameter, const QString& toolTip) {
  auto* slider = new ParameterSlider(parameterTitle(parameter), toolTip, {}, this);
  sliders_[parameter] = slider;
  layout()->addWidget(slider);
  connect(slider, &ParameterSlider::valueChanged, this,
          [this, parameter](double factor, bool stillMoving) {
            sliderMoved(parameter, factor, stillMoving);
          });
  connect(slider, &ParameterSlider::entryRefused, this, &EditPanel::updateReset);
  connect(slider, &ParameterSlider::stepEnded, this, &EditPanel::stepEnded);
}

void EditPanel::sliderMoved(Parameter parameter, double factor, bool stillMoving) {
  const bool isBlood = parameter == kHaemoglobinDermal || parameter == kHaemoglobinEpidermal;
  if (isBlood && link_->isChecked()) {
    const Parameter partner =
        parameter == kHaemoglobinDermal ? kHaemoglobinEpidermal : kHaemoglobinDermal;
    sliders_[partner]->setValue(factor);
    Q_EMIT factorChanged(partner, factor, true);
  }
  updateReset();
  Q_EMIT factorChanged(parameter, factor, stillMoving);
}

// Linking brings the epidermal factor to the dermal one.
void EditPanel::linkToggled(bool linked) {
  const double factor = sliders_[kHaemoglobinDermal]->value();
  if (!linked || sliders_[kHaemoglobinEpidermal]->value() == factor) return;
  sliders_[kHaemoglobinEpidermal]->setValue(factor);
  updateReset();
  Q_EMIT factorChanged(kHaemoglobinEpidermal, factor, false);
  Q_EMIT stepEnded();
}

void EditPanel::setFactors(const std::array<double, kParameterCount>& factors) {
  for (const Parameter parameter : kParameters) {
    sliders_[parameter]->setValue(factors[parameter]);
    if (sliders_[parameter]->isEntryRefused()) sliders_[parameter]->dropEntry();
  }
  if (factors[kHaemoglobinDermal] != factors[kHaemoglobinEpidermal]) {
    const QSignalBlocker silent(link_);
    link_->setChecked(false);
  }
  updateReset();
}

std::array<double, kParameterCount> EditPanel::factors() const {
  std::array<double, kParameterCount> factors{};
  for (const Parameter parameter : kParameters)
    factors[parameter] = sliders_[parameter]->value();
  return factors;
}

void EditPanel::setResting(const QString& why) {
  for (ParameterSlider* slider : sliders_)
    slider->setResting(why);
  isResting_ = !why.isEmpty();
  link_->setEnabled(!isResting_);
  presets_->setEnabled(!isResting_);
  updateReset();
}

void EditPanel::setFurtherEdits(bool any) {
  furtherEdits_ = any;
  updateReset();
}

void EditPanel::setPresets(QMenu* menu) {
  menu->setParent(this, menu->windowFlags());
  presets_->setMenu(menu);
  presets_->show();
}

void EditPanel::updateReset() {
  const bool any = std::any_of(sliders_.begin(), sliders_.end(), [](const ParameterSlider* s) {
    return s->value() != kNeutral || s->isEntryRefused();
  });
  reset_->setEnabled(!isResting_ && (any || furtherEdits_));
}

}  // namespace cutis
