#include "ui/widgets/error_table.h"

#include <cmath>

#include <QGridLayout>
#include <QLabel>
#include <QLocale>

#include "ui/theme/theme.h"

namespace cutis {
namespace {

// Reflectances that differ by less look alike side by side (ΔE2000 of about a half and of about two
// on skin of middle tone).
constexpr double kInvisible = 0.005;
constexpr double kSlight = 0.02;

QString verdictOf(double meanSquaredError) {
  const double error = std::sqrt(meanSquaredError);
  if (error < kInvisible) return ErrorTable::tr("Too small a difference to be seen.");
  if (error < kSlight) return ErrorTable::tr("A slight difference; Refined is closer.");
  return ErrorTable::tr("A visible difference; use Refined where colour counts.");
}

void setError(QLabel& label, double meanSquaredError) {
  label.setText(errorText(meanSquaredError));
  label.setToolTip(
      ErrorTable::tr("Mean squared error %1").arg(QLocale().toString(meanSquaredError, 'e', 1)));
}

}  // namespace

QString errorText(double meanSquaredError) {
  return ErrorTable::tr("%1 %").arg(QLocale().toString(100 * std::sqrt(meanSquaredError), 'g', 2));
}

ErrorTable::ErrorTable(QWidget* parent)
    : QWidget(parent),
      grid_(new QGridLayout(this)),
      verdict_(new QLabel(this)),
      maps_(new QLabel(this)),
      mapsNoisy_(new QLabel(this)),
      spectra_(new QLabel(this)),
      both_(new QLabel(this)),
      bothNoisy_(new QLabel(this)) {
  setAccessibleName(tr("Errors reached"));
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(theme::kDoubleSpace);
  grid_->setVerticalSpacing(theme::kHalfSpace);
  grid_->setColumnStretch(0, 1);
  auto* subject = new QLabel(tr("Difference from the exact model, visible light"), this);
  subject->setFont(theme::headingFont(*this));
  grid_->addWidget(subject, 0, 0);
  int column = 1;
  for (const QString& title : {tr("no noise"), tr("usual noise")}) {
    grid_->addWidget(new QLabel(title, this), 0, column++, Qt::AlignRight);
  }
  addRow(1, tr("Maps of photographs"), tr("ChromNN and the skin model: what the fit gives"), maps_,
         mapsNoisy_);
  addRow(2, tr("Spectra of maps"), tr("SpectraNN"), spectra_, new QLabel(tr("–"), this));
  addRow(3, tr("Both, one after the other"), tr("ChromNN and SpectraNN"), both_, bothNoisy_);
  grid_->setRowMinimumHeight(4, theme::kHalfSpace);
  grid_->addWidget(verdict_, 5, 0, 1, 3);
}

void ErrorTable::addRow(int row, const QString& name, const QString& toolTip, QLabel* clean,
                        QLabel* noisy) {
  auto* label = new QLabel(name, this);
  label->setToolTip(toolTip);
  grid_->addWidget(label, row, 0);
  grid_->addWidget(clean, row, 1, Qt::AlignRight);
  grid_->addWidget(noisy, row, 2, Qt::AlignRight);
}

void ErrorTable::setErrors(const NetworkErrors& errors) {
  setError(*maps_, errors.encoded);
  setError(*mapsNoisy_, errors.encodedNoisy);
  setError(*spectra_, errors.decoded);
  setError(*both_, errors.both);
  setError(*bothNoisy_, errors.bothNoisy);
  verdict_->setText(verdictOf(errors.encodedNoisy));
}

}  // namespace cutis
