#pragma once

// Plot of reflectance against wavelength, 300–1000 nm: original and edited curve, the photograph's
// channels as points with bars, the bands shaded and named, and a crosshair with the numbers under
// it. The crosshair follows the mouse, or the arrow keys when the plot has the keyboard (shift: one
// sample; escape hides it). A right click offers to copy the curves.
//
// Reflectance is a share: 0 none, 1 a perfect diffuser. NaN leaves a gap. Interface thread only.

#include <optional>

#include <QString>
#include <QVector>
#include <QWidget>

#include "ui/plot/panel_view.h"

namespace cutis {

// One channel of the photograph, as reflectance.
struct MeasuredChannel {
  QString name;             // "white, G"
  double wavelengthNm = 0;  // where most of its response lies
  double halfWidthNm = 0;   // of its response; drawn as a horizontal bar
  double reflectance = 0;
  double deviation = 0;  // standard deviation; drawn as a vertical bar
};

class SpectrumPlot : public QWidget {
  Q_OBJECT

 public:
  explicit SpectrumPlot(QWidget* parent = nullptr);

  // On the grid of core/spectra/grid.h, 351 values each; an empty `edited` draws the original
  // alone. A curve of any other length is taken as empty.
  // `deviation`: standard deviations of the original, of which two are drawn on either side; empty:
  // none are known.
  void setCurves(const QVector<double>& original, const QVector<double>& edited,
                 const QVector<double>& deviation = {});
  void setMeasured(const QVector<MeasuredChannel>& channels);
  // What the curves belong to: "Pixel 812, 440".
  void setHeading(const QString& heading);
  const QString& heading() const { return heading_; }
  // Back to the empty state.
  void clear();

  // Where a value is drawn, in the widget's pixels.
  QPointF pointAt(double wavelengthNm, double reflectance) const;
  // The upper end of the axis, which starts at 0.
  double maximum() const { return maximum_; }
  // The sample under the crosshair.
  std::optional<int> crosshair() const { return crosshair_; }
  // A table with tabs between its columns, as spreadsheets take it; empty without curves.
  QString curvesText() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  // All that is to be seen, at the moment.
  Panel panel() const;
  Panel emptyPanel() const;
  void addCurve(Panel& panel, const QVector<double>& values, const QString& name,
                const Stroke& stroke) const;
  void addBand(Panel& panel) const;
  void addMeasured(Panel& panel) const;
  QString legendText(const QString& name, const QVector<double>& curve) const;
  QRectF outside() const;
  const PlotTheme& plotTheme() const;
  PanelLayout layout() const;
  void setCrosshair(std::optional<int> sample);
  void fitAxis();

  QVector<double> original_;
  QVector<double> edited_;
  QVector<double> deviation_;
  QVector<MeasuredChannel> measured_;
  QString heading_;
  double maximum_ = 1;
  std::optional<int> crosshair_;
  mutable PanelView view_;
};

}  // namespace cutis
