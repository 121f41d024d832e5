#include "ui/dialogs/fit_options_dialog.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "src/app/document/document.h"
#include "ui/dialogs/file_field.h"
#include "ui/theme/theme.h"
#include "ui/widgets/parameter_texts.h"

namespace cutis {
namespace {

enum SpecularKind { kUnknown, kKeptOut, kContained };
enum NoiseKind { kOfRig, kOwn, kNone };
enum DiscrepancyKind { kUsual, kOn, kOff };

constexpr double kMostNoise = 1.0;
constexpr int kNoiseDecimals = 5;
constexpr int kValueDecimals = 4;
constexpr double kShareStep = 0.005;
constexpr int kLightsInRow = 3;

}  // namespace

FitOptionsDialog::FitOptionsDialog(const FitChoice& choice, const Profile& profile,
                                   const std::array<double, 2>& usualNoise,
                                   const CaptureLights& lights, QWidget* parent)
    : QDialog(parent),
      base_(choice),
      profile_(profile),
      usualNoise_(usualNoise),
      specular_(new QComboBox(this)),
      share_(new QDoubleSpinBox(this)),
      noise_(new QComboBox(this)),
      deviations_{new QDoubleSpinBox(this), new QDoubleSpinBox(this)},
      prior_(new FileField({tr("Prior"), tr("The profile's"),
                            tr("A JSON file with what is known of the skin beforehand"),
                            tr("Choose prior"), tr("Priors (*.json);;All files (*)")},
                           {}, this)),
      held_{},
      oxygenation_(new QCheckBox(tr("Oxygenation of the blood"), this)),
      thickness_(new QCheckBox(tr("Thickness of the epidermis"), this)),
      discrepancy_(new QComboBox(this)),
      note_(new QLabel(this)),
      fit_(new QPushButton(tr("&Fit"), this)) {
  setWindowTitle(tr("Fit options"));
  setAccessibleName(windowTitle());
  auto* form = new QFormLayout;
  form->setContentsMargins(0, 0, 0, 0);
  form->setSpacing(theme::kSpace);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  addCapture(*form, lights);
  addNoise(*form, usualNoise);
  form->addRow(tr("&Prior"), prior_);
  addHeld(*form);
  addFound(*form);
  note_->setWordWrap(true);
  note_->setAccessibleName(tr("What cannot be"));
  QPalette palette = note_->palette();
  palette.setColor(QPalette::WindowText, theme::tones().error);
  note_->setPalette(palette);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(theme::kDoubleSpace, theme::kDoubleSpace, theme::kDoubleSpace,
                             theme::kDoubleSpace);
  column->setSpacing(theme::kSpace);
  column->addLayout(form);
  column->addStretch(1);
  column->addWidget(note_);
  column->addWidget(buttons());
  orderTabs();
  take(choice);
}

void FitOptionsDialog::addCapture(QFormLayout& form, const CaptureLights& lights) {
  auto* grid = new QGridLayout;
  grid->setSpacing(theme::kSpace);
  for (const std::string& name : lights.all) {
    auto* box = new QCheckBox(QString::fromStdString(name), this);
    box->setChecked(std::find(lights.used.begin(), lights.used.end(), name) != lights.used.end());
    box->setToolTip(tr("Whether the photograph under this light is used"));
    connect(box, &QCheckBox::toggled, this, &FitOptionsDialog::check);
    const int count = static_cast<int>(lights_.size());
    grid->addWidget(box, count / kLightsInRow, count % kLightsInRow);
    lights_.push_back(box);
  }
  form.addRow(tr("Lights"), grid);
  form.setRowVisible(grid, !lights.all.empty());
  specular_->addItem(tr("Not known"));
  specular_->addItem(tr("Kept out, by polarisers or the lights' direction"));
  specular_->addItem(tr("In the photographs: take it off"));
  specular_->setAccessibleName(tr("Surface reflection"));
  specular_->setToolTip(
      tr("The light that the skin's surface reflects before it has been in the skin"));
  share_->setRange(0.0, kMostSpecularShare);
  share_->setDecimals(kValueDecimals);
  share_->setSingleStep(kShareStep);
  share_->setAccessibleName(tr("Surface reflection, share"));
  share_->setToolTip(tr("Where a white diffuser reads 1"));
  connect(specular_, &QComboBox::currentIndexChanged, this, &FitOptionsDialog::check);
  auto* row = new QHBoxLayout;
  row->setSpacing(theme::kSpace);
  row->addWidget(specular_, 1);
  row->addWidget(share_);
  form.addRow(tr("Surface reflection"), row);
  form.setRowVisible(row, !lights.all.empty());
}

void FitOptionsDialog::addNoise(QFormLayout& form, const std::array<double, 2>& usual) {
  noise_->addItem(tr("As the rig has it (%1 and %2)").arg(usual[0]).arg(usual[1]));
  noise_->addItem(tr("My own"));
  noise_->addItem(tr("None: the exact solution"));
  noise_->setAccessibleName(tr("Noise"));
  noise_->setToolTip(tr("How far a channel may be off, where a white diffuser reads 1"));
  form.addRow(tr("&Noise"), noise_);
  auto* row = new QHBoxLayout;
  row->setSpacing(theme::kSpace);
  const std::array<QString, 2> names = {tr("constant"), tr("proportional")};
  for (std::size_t k = 0; k < deviations_.size(); ++k) {
    deviations_[k]->setRange(0.0, kMostNoise);
    deviations_[k]->setDecimals(kNoiseDecimals);
    deviations_[k]->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    deviations_[k]->setAccessibleName(tr("Noise, %1").arg(names[k]));
    row->addWidget(deviations_[k]);
    row->addWidget(new QLabel(names[k], this));
    connect(deviations_[k], &QDoubleSpinBox::valueChanged, this, &FitOptionsDialog::check);
  }
  row->addStretch(1);
  form.addRow(QString(), row);
  connect(noise_, &QComboBox::currentIndexChanged, this, &FitOptionsDialog::check);
}

void FitOptionsDialog::addHeld(QFormLayout& form) {
  for (const Parameter parameter : kParameters) {
    const auto k = static_cast<std::size_t>(parameter);
    const QString title = parameterTitle(parameter);
    HeldRow& row = held_[k];
    row = {new QCheckBox(title, this), new QDoubleSpinBox(this)};
    row.held->setToolTip(tr("At this value everywhere, instead of being estimated"));
    row.value->setRange(0.0, profile_.axes[k].maximum);
    row.value->setDecimals(kValueDecimals);
    row.value->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    row.value->setAccessibleName(tr("%1, held at").arg(title));
    connect(row.held, &QCheckBox::toggled, this, &FitOptionsDialog::check);
    auto* line = new QHBoxLayout;
    line->setSpacing(theme::kSpace);
    line->addWidget(row.held, 1);
    line->addWidget(row.value);
    form.addRow(parameter == kParameters.front() ? tr("Hold") : QString(), line);
  }
}

void FitOptionsDialog::addFound(QFormLayout& form) {
  for (QCheckBox* box : {oxygenation_, thickness_}) {
    box->setToolTip(tr("Found for each pixel, where there are channels enough to tell it"));
    connect(box, &QCheckBox::toggled, this, &FitOptionsDialog::check);
  }
  form.addRow(tr("Find"), oxygenation_);
  form.addRow(QString(), thickness_);
  discrepancy_->addItem(tr("Where the profile knows it"));
  discrepancy_->addItem(tr("On"));
  discrepancy_->addItem(tr("Off"));
  discrepancy_->setAccessibleName(tr("Discrepancy"));
  discrepancy_->setToolTip(tr("What the skin model leaves over of measured skin"));
  connect(discrepancy_, &QComboBox::currentIndexChanged, this, &FitOptionsDialog::check);
  form.addRow(tr("&Discrepancy"), discrepancy_);
}

QWidget* FitOptionsDialog::buttons() {
  auto* box = new QDialogButtonBox(this);
  fit_->setProperty("primary", true);
  fit_->setDefault(true);
  box->addButton(fit_, QDialogButtonBox::AcceptRole);
  box->addButton(QDialogButtonBox::Cancel);
  auto* reset = box->addButton(tr("&Reset"), QDialogButtonBox::ResetRole);
  connect(box, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(box, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(reset, &QPushButton::clicked, this, [this] {
    take({});
    for (QCheckBox* light : lights_)
      light->setChecked(true);
  });
  return box;
}

// As the eye goes, whichever was made first.
void FitOptionsDialog::orderTabs() {
  std::vector<QWidget*> order(lights_.begin(), lights_.end());
  order.insert(order.end(), {specular_, share_, noise_, deviations_[0], deviations_[1], prior_});
  for (const HeldRow& row : held_)
    order.insert(order.end(), {row.held, row.value});
  order.insert(order.end(), {oxygenation_, thickness_, discrepancy_, fit_});
  for (std::size_t k = 1; k < order.size(); ++k)
    setTabOrder(order[k - 1], order[k]);
}

void FitOptionsDialog::takeSpecular(const FitChoice& choice) {
  specular_->setCurrentIndex(!choice.specular                            ? kUnknown
                             : choice.specular == SpecularPart::included ? kContained
                                                                         : kKeptOut);
  share_->setValue(choice.specularShare);
}

void FitOptionsDialog::take(const FitChoice& choice) {
  takeSpecular(choice);
  const bool isExact = choice.noise == std::array<double, 2>{0.0, 0.0};
  noise_->setCurrentIndex(!choice.noise ? kOfRig : isExact ? kNone : kOwn);
  const auto shown = choice.noise.value_or(usualNoise_);
  for (std::size_t k = 0; k < deviations_.size(); ++k)
    deviations_[k]->setValue(shown[k]);
  prior_->setPath(choice.prior);
  for (std::size_t k = 0; k < held_.size(); ++k) {
    held_[k].held->setChecked(choice.fixed[k].has_value());
    held_[k].value->setValue(choice.fixed[k].value_or(profile_.prior.mean[k]));
  }
  oxygenation_->setChecked(choice.free.oxygenation);
  thickness_->setChecked(choice.free.thickness);
  discrepancy_->setCurrentIndex(!choice.discrepancy ? kUsual : *choice.discrepancy ? kOn : kOff);
  check();
}

FitChoice FitOptionsDialog::choice() const {
  FitChoice choice = base_;
  choice.noise.reset();
  if (noise_->currentIndex() == kOwn) {
    choice.noise = {deviations_[0]->value(), deviations_[1]->value()};
  } else if (noise_->currentIndex() == kNone) {
    choice.noise = {0.0, 0.0};
  }
  choice.prior = prior_->path().string();
  for (std::size_t k = 0; k < held_.size(); ++k) {
    choice.fixed[k].reset();
    if (held_[k].held->isChecked()) choice.fixed[k] = held_[k].value->value();
  }
  choice.free = {oxygenation_->isChecked(), thickness_->isChecked()};
  choice.discrepancy.reset();
  if (discrepancy_->currentIndex() != kUsual) {
    choice.discrepancy = discrepancy_->currentIndex() == kOn;
  }
  addSpecular(choice);
  if (choice.hasRefinements()) choice.method = FitMethod::refined;
  return choice;
}

// Polarisers or not, what is kept out is out.
void FitOptionsDialog::addSpecular(FitChoice& choice) const {
  const bool wasKeptOut = choice.specular && *choice.specular != SpecularPart::included;
  switch (specular_->currentIndex()) {
    case kUnknown:
      choice.specular.reset();
      break;
    case kKeptOut:
      if (!wasKeptOut) choice.specular = SpecularPart::excluded;
      break;
    default:
      choice.specular = SpecularPart::included;
  }
  if (specular_->currentIndex() == kContained) choice.specularShare = share_->value();
}

std::vector<std::string> FitOptionsDialog::lights() const {
  std::vector<std::string> used;
  for (const QCheckBox* light : lights_) {
    if (light->isChecked()) used.push_back(light->text().toStdString());
  }
  return used.size() == lights_.size() ? std::vector<std::string>() : used;
}

QString FitOptionsDialog::objection() const {
  const FitChoice chosen = choice();
  if (std::all_of(chosen.fixed.begin(), chosen.fixed.end(),
                  [](const auto& value) { return value.has_value(); })) {
    return tr("All five parameters are held; leave at least one to be estimated.");
  }
  const bool isDark =
      !lights_.empty() && std::none_of(lights_.begin(), lights_.end(),
                                       [](const QCheckBox* light) { return light->isChecked(); });
  if (isDark) return tr("No light is used; choose at least one.");
  if (chosen.specular == SpecularPart::included && chosen.shading) {
    return tr("The surface's reflection cannot be told apart from shading; switch one off.");
  }
  if (chosen.free.count() > 0 && chosen.discrepancy.value_or(false)) {
    return tr("Constants that are found explain what the discrepancy would; leave one out.");
  }
  if (chosen.free.count() > 0 && chosen.shading) {
    return tr("Constants that are found look much like shading; switch one off.");
  }
  return {};
}

void FitOptionsDialog::check() {
  for (QDoubleSpinBox* deviation : deviations_)
    deviation->setEnabled(noise_->currentIndex() == kOwn);
  for (const HeldRow& row : held_)
    row.value->setEnabled(row.held->isChecked());
  share_->setEnabled(specular_->currentIndex() == kContained);
  const QString why = objection();
  note_->setText(why);
  note_->setVisible(!why.isEmpty());
  fit_->setEnabled(why.isEmpty());
}

void askForFitOptions(Document& document, QWidget& window) {
  const Scene& scene = document.scene();
  const Rig& rig = scene.source->measurements.rig;
  CaptureLights lights = {scene.source->lights, {}};
  for (const RigLight& light : rig.lights)
    lights.used.push_back(light.name);
  auto* dialog = new FitOptionsDialog(document.fitChoice(), scene.model->profile(),
                                      {rig.noise.read, rig.noise.proportional}, lights, &window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &QDialog::accepted, &document,
                   [dialog, &document] { document.fitWith(dialog->choice(), dialog->lights()); });
  dialog->open();
}

}  // namespace cutis
