#include "ui/docks/fit_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>

#include "ui/docks/fit_catalogue.h"
#include "ui/theme/theme.h"
#include "ui/widgets/exposure_control.h"

namespace cutis {

FitPanel::FitPanel(QWidget* parent)
    : QWidget(parent),
      profile_(new QComboBox(this)),
      load_(new QPushButton(tr("Load…"), this)),
      form_(new QFormLayout),
      method_(new QComboBox(this)),
      exposure_(new ExposureControl(this)),
      shading_(new QCheckBox(tr("Estimate shading"), this)),
      fit_(new QPushButton(tr("Fit"), this)),
      options_(new QPushButton(tr("Options…"), this)),
      offer_(new QWidget(this)) {
  setAccessibleName(tr("Fit"));
  profile_->setAccessibleName(tr("Profile"));
  method_->setAccessibleName(tr("Method"));
  load_->setAccessibleName(tr("Load a profile"));
  for (const std::string& name : profileNames())
    offerProfile(QString::fromStdString(name));
  for (const MethodDescription& method : methodCatalogue()) {
    method_->addItem(method.name, static_cast<int>(method.method));
  }
  addForm();
  addOffer();
  connectControls();
  fit_->setToolTip(tr("The fit was cancelled; do it now"));
  setFitOffered(false);
  show({}, Subject::photographs);
}

void FitPanel::connectControls() {
  const auto notify = [this] { Q_EMIT changed(choice()); };
  connect(profile_, &QComboBox::activated, this, notify);
  connect(method_, &QComboBox::activated, this, notify);
  connect(shading_, &QCheckBox::clicked, this, notify);
  connect(load_, &QPushButton::clicked, this, &FitPanel::loadWanted);
  connect(fit_, &QPushButton::clicked, this, &FitPanel::fitWanted);
  connect(options_, &QPushButton::clicked, this, &FitPanel::optionsWanted);
  connect(exposure_, &ExposureControl::chosen, this, [this](double exposure) {
    shown_.exposure = exposure;
    Q_EMIT changed(choice());
  });
  connect(exposure_, &ExposureControl::automaticWanted, this, [this] {
    shown_.exposure.reset();
    Q_EMIT changed(choice());
  });
}

void FitPanel::addForm() {
  for (QComboBox* box : {profile_, method_}) {
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  }
  auto* profileRow = new QHBoxLayout;
  profileRow->setSpacing(theme::kSpace);
  profileRow->addWidget(profile_, 1);
  profileRow->addWidget(load_);
  form_->addRow(tr("Profile"), profileRow);
  form_->addRow(tr("Method"), method_);
  form_->addRow(tr("Exposure"), exposure_);
  theme::alignForm(*form_);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(theme::kSpace);
  column->addLayout(form_);
  auto* foot = new QHBoxLayout;
  foot->setSpacing(theme::kSpace);
  foot->addWidget(shading_);
  foot->addStretch(1);
  foot->addWidget(options_);
  column->addLayout(foot);
  column->addWidget(fit_);
  column->addWidget(offer_);
}

void FitPanel::addOffer() {
  auto* sentence = new QLabel(tr("No network knows these lights with this profile yet."), offer_);
  sentence->setWordWrap(true);
  auto* train = new QPushButton(tr("Train one (about 15 s)"), offer_);
  auto* column = new QVBoxLayout(offer_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(theme::kSpace);
  column->addWidget(sentence);
  column->addWidget(train);
  connect(train, &QPushButton::clicked, this, &FitPanel::trainingWanted);
}

void FitPanel::offerProfile(const QString& profile) {
  const QString builtIn = profileToolTip(profile);
  profile_->addItem(builtIn.isEmpty() ? QFileInfo(profile).completeBaseName() : profile, profile);
  profile_->setItemData(profile_->count() - 1,
                        builtIn.isEmpty() ? QDir::toNativeSeparators(profile) : builtIn,
                        Qt::ToolTipRole);
}

FitChoice FitPanel::choice() const {
  FitChoice choice = shown_;
  choice.profile = profile_->currentData().toString().toStdString();
  choice.method = static_cast<FitMethod>(method_->currentData().toInt());
  choice.shading = shading_->isChecked();
  return choice;
}

void FitPanel::show(const FitChoice& choice, Subject subject) {
  shown_ = choice;
  showProfile(QString::fromStdString(choice.profile), subject);
  showMethod(choice);
  showOptions(choice);
  showShading(choice, subject);
  form_->setRowVisible(exposure_, subject == Subject::texture);
  const QList<QWidget*> controls = {profile_, load_, method_, options_};
  const bool fits = subject != Subject::maps;
  for (QWidget* control : controls)
    control->setEnabled(fits);
  load_->setToolTip(tr("A profile of the skin model from a JSON file"));
  if (!fits) {
    for (QWidget* control : controls + QList<QWidget*>{shading_})
      control->setToolTip(
          tr("Maps stay as they were fitted; open their photographs to fit them again"));
  }
  offer_->hide();
}

// Maps may be of a profile that nobody can choose.
void FitPanel::showProfile(const QString& profile, Subject subject) {
  if (profile != tried_ && !tried_.isEmpty()) {
    profile_->removeItem(profile_->findData(tried_));
    tried_.clear();
  }
  if (subject != Subject::maps && profile_->findData(profile) < 0) {
    offerProfile(profile);
    tried_ = profile;
  }
  profile_->setPlaceholderText(profile);
  profile_->setCurrentIndex(profile_->findData(profile));
  profile_->setToolTip(profile_->currentData(Qt::ToolTipRole).toString());
}

void FitPanel::showMethod(const FitChoice& choice) {
  auto* items = qobject_cast<QStandardItemModel*>(method_->model());
  for (int row = 0; row < method_->count(); ++row) {
    const MethodDescription& method = methodCatalogue()[static_cast<std::size_t>(row)];
    const bool isRefined = method.method == FitMethod::refined;
    const bool can = isRefined || (!choice.shading && !choice.hasRefinements());
    items->item(row)->setEnabled(can);
    items->item(row)->setToolTip(
        can              ? method.toolTip
        : choice.shading ? tr("Cannot estimate shading; switch that off first")
                         : tr("Knows none of the options that are set; reset them first"));
  }
  method_->setCurrentIndex(method_->findData(static_cast<int>(choice.method)));
  method_->setToolTip(method_->currentData(Qt::ToolTipRole).toString());
}

void FitPanel::showShading(const FitChoice& choice, Subject subject) {
  shading_->setChecked(choice.shading);
  shading_->setEnabled(subject == Subject::photographs && choice.method == FitMethod::refined);
  if (subject == Subject::texture) {
    shading_->setToolTip(tr("A texture is taken as albedo, without shades"));
  } else if (choice.method != FitMethod::refined) {
    shading_->setToolTip(tr("Only the method Refined can estimate shading"));
  } else {
    shading_->setToolTip(tr(
        "One more factor per pixel, for photographs with slopes and shades. Leave it off in flat "
        "light: shade and melanin look much alike."));
  }
}

void FitPanel::showExposure(double exposure, const std::optional<double>& shareInRange) {
  exposure_->show(exposure, !shown_.exposure.has_value(), shareInRange);
}

void FitPanel::setFitOffered(bool offered) {
  fit_->setVisible(offered);
}

void FitPanel::showOptions(const FitChoice& choice) {
  const bool isSet = choice.hasRefinements() || choice.specular;
  options_->setText(isSet ? tr("Options (set)…") : tr("Options…"));
  options_->setToolTip(
      tr("Lights, surface reflection, noise, prior, parameters that are held, constants found per "
         "pixel"));
}

void FitPanel::offerTraining() {
  offer_->show();
  Q_EMIT trainingOffered();
}

}  // namespace cutis
