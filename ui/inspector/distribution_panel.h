#pragma once

// How the values of the current view are spread, and where the picture's colours lie among those
// of skin. Interface thread only.

#include <QWidget>

class QCheckBox;
class QLabel;

namespace cutis {

class HistogramPlot;
struct HistogramSpec;
class LocusPlot;

class DistributionPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DistributionPanel(QWidget* parent = nullptr);

  void setHistogram(const HistogramSpec& spec);
  HistogramPlot& histogram() { return *histogram_; }
  LocusPlot& locus() { return *locus_; }

 private:
  QLabel* counted_;  // what the histogram counts
  HistogramPlot* histogram_;
  QCheckBox* logarithmic_;
  LocusPlot* locus_;
};

}  // namespace cutis
