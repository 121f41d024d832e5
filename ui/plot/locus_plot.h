#pragma once

// Chromaticities of a picture over the sheet of colours that skin can have, CIE 1976 u′, v′.
// Interface thread only.

#include <vector>

#include <QImage>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QWidget>

#include "ui/plot/panel_view.h"

namespace cutis {

struct LocusCurve {
  QString words;  // "melanin 5 %"
  bool isMelanin = true;
  std::vector<QPointF> points;  // u′, v′
};

class LocusPlot : public QWidget {
  Q_OBJECT

 public:
  explicit LocusPlot(QWidget* parent = nullptr);

  void setSheet(const std::vector<LocusCurve>& curves);
  // What is not finite is left out. Any number: they are drawn as a density.
  void setColors(std::vector<QPointF> colors);
  // Where the pixel under the cursor lies; null: nowhere.
  void setCursor(const QPointF& color);

  // Where a chromaticity is drawn, in the widget's pixels.
  QPointF placeOf(const QPointF& color);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Panel panel();
  QRectF outside() const;
  QImage density(const PanelLayout& layout) const;

  std::vector<LocusCurve> sheet_;
  std::vector<QPointF> colors_;
  QPointF cursor_;
  QRectF bounds_ = {0.0, 0.0, 1.0, 1.0};  // of what is shown
  PanelView view_;
};

}  // namespace cutis
