#pragma once

// Error of networks while they are trained, epoch by epoch, one network beside the other: of the
// skin they learn from, and of skin held back from them. Logarithmic.
//
// Errors are root mean squares of reflectance, shown in percent of a perfect diffuser. What is not
// positive and finite leaves a gap. Interface thread only.

#include <vector>

#include <QString>
#include <QVector>
#include <QWidget>

#include "ui/plot/panel_view.h"

namespace cutis {

struct LossCurve {
  QString name;    // "SpectraNN"
  int epochs = 1;  // that it will have at most; at least 1
  QVector<double> trained;
  QVector<double> heldOut;  // as many
};

class LossPlot : public QWidget {
  Q_OBJECT

 public:
  explicit LossPlot(QWidget* parent = nullptr);

  // In the order of training.
  void setCurves(const std::vector<LossCurve>& curves);

  // Where an error after an epoch (the first is 1) of a curve is drawn, in the widget's pixels.
  QPointF pointAt(std::size_t curve, double epoch, double error) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Panel panel() const;
  void addCurve(Panel& panel, const LossCurve& curve, double before) const;
  // Epochs of the networks before one.
  double epochsBefore(std::size_t curve) const;
  QRectF outside() const;
  void fitAxis();

  std::vector<LossCurve> curves_;
  double minimum_ = 1e-4;
  double maximum_ = 1e-2;
  mutable PanelView view_;
};

}  // namespace cutis
