#pragma once

// How the values of the current view are spread, and where the picture's colours lie among those
// of skin. Interface thread only.

#include <QWidget>

class QCheckBox;

namespace cutis {

class HistogramPlot;
class LocusPlot;

class DistributionPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DistributionPanel(QWidget* parent = nullptr);

  HistogramPlot& histogram() { return *histogram_; }
  LocusPlot& locus() { return *locus_; }

 private:
  HistogramPlot* histogram_;
  QCheckBox* logarithmic_;
  LocusPlot* locus_;
};

}  // namespace cutis
