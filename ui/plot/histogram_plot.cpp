#include "ui/plot/histogram_plot.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/plot/window_theme.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kMostTicksAcross = 5;
constexpr int kMostTicksUpwards = 4;

double largestOf(const std::vector<HistogramCurve>& curves) {
  double largest = 0.0;
  for (const HistogramCurve& curve : curves) {
    for (const double count : curve.counts)
      largest = std::max(largest, count);
  }
  return largest;
}

// A step for each part of the axis.
Curve stepsOf(const HistogramCurve& curve, double from, double to, const Stroke& stroke) {
  Curve steps;
  steps.stroke = stroke;
  const double width = (to - from) / static_cast<double>(curve.counts.size());
  for (std::size_t i = 0; i < curve.counts.size(); ++i) {
    for (const std::size_t end : {i, i + 1}) {
      steps.x.push_back(from + width * static_cast<double>(end));
      steps.y.push_back(curve.counts[i]);
    }
  }
  return steps;
}

}  // namespace

HistogramPlot::HistogramPlot(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Histogram"));
}

void HistogramPlot::setSpec(const HistogramSpec& spec) {
  spec_ = spec;
  setAccessibleDescription(spec.title);
  update();
}

void HistogramPlot::setLogarithmic(bool isLogarithmic) {
  isLogarithmic_ = isLogarithmic;
  update();
}

QSize HistogramPlot::sizeHint() const {
  return {300, 180};
}

QSize HistogramPlot::minimumSizeHint() const {
  return {180, 120};
}

void HistogramPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  view_.paint(painter, panel(), QRectF(rect()).adjusted(0, 0, 0, -theme::kHalfSpace), font());
}

Panel HistogramPlot::panel() {
  const PlotTheme& theme = view_.themeFor(font());
  Panel panel;
  const double largest = largestOf(spec_.curves);
  if (largest <= 0.0) {
    panel.message = tr("There are no values yet").toStdString();
    return panel;
  }
  panel.x = linearAxis(spec_.from, spec_.to, kMostTicksAcross, localTickWords);
  panel.x.title = spec_.axis.toStdString();
  panel.x.unit = spec_.unit.toStdString();
  panel.y = isLogarithmic_ ? decadeAxis(0.9, std::max(largest, 10.0))
                           : linearAxis(0.0, 1.05 * largest, kMostTicksUpwards, localTickWords);
  for (const HistogramCurve& curve : spec_.curves) {
    Stroke stroke = firstCurveStroke(theme);
    if (!curve.color.isNone()) stroke.color = curve.color;
    if (spec_.curves.size() > 1) panel.legend.push_back({curve.name.toStdString(), stroke, {}});
    panel.curves.push_back(stepsOf(curve, spec_.from, spec_.to, stroke));
  }
  return panel;
}

}  // namespace cutis
