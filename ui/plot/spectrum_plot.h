#pragma once

// Plot of spectra in the window (ui/plot/spectrum_figure.h), with a crosshair.
//
// The axis ends at the largest reflectance seen so far, so that it stays where it is from place to
// place; the wheel and the arrow keys up and down choose another end, a double click makes it
// automatic again. The crosshair follows the mouse and reads out wavelength and reflectance under
// it; the arrow keys move it along the curves (shift: one sample; escape hides it). Interface
// thread only.

#include <optional>

#include <QString>
#include <QVector>
#include <QWidget>

#include "ui/plot/panel_view.h"
#include "ui/plot/reflectance_axis.h"
#include "ui/plot/spectrum_figure.h"

namespace cutis {

class SpectrumPlot : public QWidget {
  Q_OBJECT

 public:
  explicit SpectrumPlot(QWidget* parent = nullptr);

  // Of the place under the cursor, 351 values each; a curve of any other length is taken as empty.
  void setPlace(const QString& heading, const PlaceCurves& curves,
                const QVector<MeasuredChannel>& channels = {});
  // What the place's curves belong to: "pixel 812, 440".
  const QString& heading() const { return heading_; }
  void clearPlace() { setPlace({}, {}); }
  void setPins(const std::vector<PinnedCurves>& pins);
  void setReferences(const std::vector<NamedCurve>& references);
  // Another quantity, with its curves; reflectance: the place's, the pins' and the references'.
  void setParts(SpectrumQuantity quantity, const std::vector<NamedCurve>& parts = {});
  // None: it is not known what the photographs measured.
  void setMeasured(const std::optional<Band>& measured);
  // Back to the empty state, the axis included.
  void clear();

  // All that is to be seen, for a picture on paper.
  const SpectrumFigure& figure() const { return figure_; }
  // Where a value is drawn, in the widget's pixels.
  QPointF pointAt(double wavelengthNm, double reflectance) const;
  // The upper end of the axis, which starts at 0.
  double maximum() const { return figure_.maximum; }
  // The sample under the crosshair.
  std::optional<int> crosshair() const { return crosshair_; }
  // The reflectance at the mouse; none while the crosshair is moved by keys.
  std::optional<double> pointedAt() const { return pointedAt_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  // The first curve has come, or the last one has gone.
  void emptinessChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  Panel panel() const;
  QRectF outside() const;
  const PlotTheme& plotTheme() const;
  PanelLayout layout() const;
  void setCrosshair(std::optional<int> sample, std::optional<double> pointedAt = {});
  void figureChanged();
  void stepAxis(int count);

  SpectrumFigure figure_;
  bool isEmpty_ = true;
  QString heading_;
  ReflectanceAxis axis_;
  int wheelRest_ = 0;  // of a notch
  std::optional<int> crosshair_;
  std::optional<double> pointedAt_;
  mutable PanelView view_;
};

}  // namespace cutis
