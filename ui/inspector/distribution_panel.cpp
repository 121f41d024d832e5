#include "ui/inspector/distribution_panel.h"

#include <QCheckBox>
#include <QVBoxLayout>

#include "ui/plot/histogram_plot.h"
#include "ui/plot/locus_plot.h"
#include "ui/theme/theme.h"

namespace cutis {

DistributionPanel::DistributionPanel(QWidget* parent)
    : QWidget(parent),
      histogram_(new HistogramPlot(this)),
      logarithmic_(new QCheckBox(tr("&Logarithmic counts"), this)),
      locus_(new LocusPlot(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(theme::kSpace, theme::kHalfSpace, theme::kSpace, theme::kHalfSpace);
  column->setSpacing(theme::kHalfSpace);
  column->addWidget(histogram_, 2);
  column->addWidget(logarithmic_);
  column->addWidget(locus_, 3);
  connect(logarithmic_, &QCheckBox::toggled, histogram_, &HistogramPlot::setLogarithmic);
}

}  // namespace cutis
