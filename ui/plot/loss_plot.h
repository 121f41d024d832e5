#pragma once

// Error of networks while they are trained, epoch by epoch, one network beside the other: of the
// skin they learn from, and of skin held back from them. Logarithmic.
//
// Errors are root mean squares of reflectance, shown in percent of a perfect diffuser. What is not
// positive and finite leaves a gap. Interface thread only.

#include <vector>

#include <QRectF>
#include <QString>
#include <QVector>
#include <QWidget>

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
  QRectF area() const;
  // Of one network.
  QRectF band(std::size_t curve) const;
  void fitAxis();
  void drawErrors(QPainter& painter) const;
  void drawBand(QPainter& painter, std::size_t curve) const;
  void drawCurve(QPainter& painter, std::size_t curve, const QVector<double>& errors,
                 const QPen& pen) const;

  std::vector<LossCurve> curves_;
  double minimum_ = 1e-4;
  double maximum_ = 1e-2;
};

}  // namespace cutis
