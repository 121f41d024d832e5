#include "ui/inspector/distribution_panel.h"

#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/plot/histogram_plot.h"
#include "ui/plot/locus_plot.h"
#include "ui/theme/theme.h"

namespace cutis {

DistributionPanel::DistributionPanel(QWidget* parent)
    : QWidget(parent),
      counted_(new QLabel(this)),
      histogram_(new HistogramPlot(this)),
      logarithmic_(new QCheckBox(tr("&Logarithmic counts"), this)),
      locus_(new LocusPlot(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(theme::kSpace, theme::kHalfSpace, theme::kSpace, theme::kHalfSpace);
  column->setSpacing(theme::kHalfSpace);
  auto* sheet = new QLabel(
      tr("The picture's colours over those of skin: u′ across, v′ upwards (CIE 1976)"), this);
  for (QLabel* label : {counted_, sheet}) {
    label->setFont(theme::smallFont(*label));
    label->setWordWrap(true);
    theme::dimText(*label);
  }
  column->addWidget(counted_);
  column->addWidget(histogram_, 2);
  column->addWidget(logarithmic_);
  column->addWidget(sheet);
  column->addWidget(locus_, 3);
  connect(logarithmic_, &QCheckBox::toggled, histogram_, &HistogramPlot::setLogarithmic);
}

void DistributionPanel::setHistogram(const HistogramSpec& spec) {
  counted_->setText(spec.title);
  histogram_->setSpec(spec);
}

}  // namespace cutis
