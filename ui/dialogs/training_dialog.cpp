#include "ui/dialogs/training_dialog.h"

#include <cmath>

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/theme/theme.h"
#include "ui/widgets/error_table.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

constexpr int kProgressSteps = 1000;
constexpr int kProgressHeight = 10;

}  // namespace

TrainingDialog::TrainingDialog(QWidget* parent)
    : QDialog(parent),
      heading_(new QLabel(this)),
      plot_(new LossPlot(this)),
      bar_(new QProgressBar(this)),
      status_(new QLabel(this)),
      errors_(new ErrorTable(this)),
      use_(new QPushButton(tr("Use it"), this)),
      save_(new QPushButton(tr("Save weights…"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setWindowTitle(tr("Train a network"));
  setAccessibleName(windowTitle());
  heading_->setWordWrap(true);
  bar_->setRange(0, kProgressSteps);
  bar_->setTextVisible(false);
  bar_->setFixedHeight(kProgressHeight);
  bar_->setAccessibleName(tr("Progress of the training"));
  status_->setWordWrap(true);
  use_->setProperty("primary", true);
  use_->setToolTip(tr("Fit this document with it; kept until Cutis is closed"));
  save_->setToolTip(tr("A file for fits by networks of this rig and profile"));

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(theme::kDoubleSpace, theme::kDoubleSpace, theme::kDoubleSpace,
                             theme::kDoubleSpace);
  column->setSpacing(theme::kSpace);
  column->addWidget(heading_);
  column->addSpacing(theme::kSpace);
  column->addWidget(plot_, 1);
  column->addWidget(bar_);
  column->addWidget(status_);
  column->addSpacing(theme::kHalfSpace);
  column->addWidget(errors_);
  column->addSpacing(theme::kSpace);
  addButtons();
}

void TrainingDialog::addButtons() {
  auto* row = new QHBoxLayout;
  row->setSpacing(theme::kSpace);
  row->addStretch(1);
  for (QPushButton* button : {cancel_, save_, use_}) {
    button->setAutoDefault(false);
    row->addWidget(button);
  }
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
  connect(use_, &QPushButton::clicked, this, &TrainingDialog::useWanted);
  connect(save_, &QPushButton::clicked, this, &TrainingDialog::saveWanted);
  connect(cancel_, &QPushButton::clicked, this, &TrainingDialog::reject);
}

void TrainingDialog::showButtons(bool training, bool trained) {
  training_ = training;
  bar_->setVisible(training);
  errors_->setVisible(trained);
  use_->setVisible(trained);
  save_->setVisible(trained);
  cancel_->setText(training ? tr("Cancel") : tr("Close"));
  if (trained) use_->setFocus();
}

void TrainingDialog::begin(const QString& rig, const QString& profile,
                           const NetworkTraining& training) {
  heading_->setText(
      tr("Two networks learn the skin of profile %1 as the rig %2 sees it: SpectraNN from maps to "
         "spectra, then ChromNN from photographs to maps.")
          .arg(QFileInfo(profile).completeBaseName(), rig));
  curves_ = {
      {networkName(NetworkKind::spectra), training.spectra.trainer.epochs, {}, {}},
      {networkName(NetworkKind::chromophores), training.chromophores.trainer.epochs, {}, {}}};
  plot_->setCurves(curves_);
  bar_->setValue(0);
  setStatus(tr("The training begins"), false);
  showButtons(true, false);
  cancel_->setFocus();
}

void TrainingDialog::showProgress(const QString& stage, double fraction, double secondsLeft) {
  if (!training_) return;
  bar_->setValue(static_cast<int>(std::lround(kProgressSteps * fraction)));
  if (stage.isEmpty()) return;
  const QString text = stage.left(1).toUpper() + stage.mid(1);
  status_->setText(secondsLeft < 0 ? text : tr("%1, %2").arg(text, timeLeftText(secondsLeft)));
}

void TrainingDialog::addEpoch(const NetworkEpoch& epoch) {
  LossCurve& curve = curves_[epoch.network == NetworkKind::spectra ? 0 : 1];
  curve.trained << std::sqrt(epoch.epoch.trainedError);
  curve.heldOut << std::sqrt(epoch.epoch.heldOutError);
  plot_->setCurves(curves_);
}

void TrainingDialog::showResult(const NetworkErrors& errors, double seconds) {
  errors_->setErrors(errors);
  status_->setText(tr("Trained in %1 s").arg(seconds, 0, 'f', 0));
  showButtons(false, true);
  // The table takes nothing from the plot.
  layout()->activate();
  resize(size().expandedTo(sizeHint()));
}

void TrainingDialog::showFailure(const QString& sentence) {
  setStatus(sentence, true);
  showButtons(false, false);
}

void TrainingDialog::showSaved(const QString& sentence, bool failed) {
  setStatus(sentence, failed);
}

void TrainingDialog::setStatus(const QString& sentence, bool isError) {
  status_->setText(sentence);
  QPalette palette = status_->palette();
  palette.setColor(QPalette::WindowText, isError ? theme::tones().error : theme::tones().text);
  status_->setPalette(palette);
}

void TrainingDialog::reject() {
  if (training_) {
    training_ = false;
    Q_EMIT cancelWanted();
  }
  QDialog::reject();
}

}  // namespace cutis
