#pragma once

// How often values occur: one step curve for each channel, over an axis with a name and a unit.
// Interface thread only.

#include <vector>

#include <QString>
#include <QWidget>

#include "ui/plot/panel_view.h"

namespace cutis {

struct HistogramCurve {
  QString name;
  Color color;                 // none: the window's own for a single curve
  std::vector<double> counts;  // of equal parts of the axis, from its lower end
};

struct HistogramSpec {
  QString title;  // "Melanin, 65,536 of 4,194,304 pixels"
  QString axis;   // "Melanin"
  QString unit;   // may be empty
  double from = 0.0;
  double to = 1.0;
  std::vector<HistogramCurve> curves;
};

class HistogramPlot : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramPlot(QWidget* parent = nullptr);

  void setSpec(const HistogramSpec& spec);
  const HistogramSpec& spec() const { return spec_; }
  // Of the counts.
  void setLogarithmic(bool isLogarithmic);
  bool isLogarithmic() const { return isLogarithmic_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Panel panel();

  HistogramSpec spec_;
  bool isLogarithmic_ = false;
  PanelView view_;
};

}  // namespace cutis
