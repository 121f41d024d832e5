#include "ui/plot/loss_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QLocale>
#include <QPainter>

#include "core/base/number_text.h"
#include "ui/plot/window_theme.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kMostEpochTicks = 5;
constexpr double kEndRadius = 2.5;
// An axis of less than this ratio would show noise as progress.
constexpr double kLeastSpan = 10;

bool canBeDrawn(double error) {
  return error > 0 && std::isfinite(error);
}

std::string percentWords(double error) {
  return percentText(error, 2);
}

}  // namespace

LossPlot::LossPlot(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Errors during training"));
}

void LossPlot::setCurves(const std::vector<LossCurve>& curves) {
  curves_ = curves;
  fitAxis();
  update();
}

// Whole ticks of the finest kind, so that the axis moves seldom.
void LossPlot::fitAxis() {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const LossCurve& curve : curves_) {
    for (const auto* errors : {&curve.trained, &curve.heldOut}) {
      for (const double error : *errors) {
        if (!canBeDrawn(error)) continue;
        least = std::min(least, error);
        most = std::max(most, error);
      }
    }
  }
  if (most == 0) return;
  const auto [below, above] = roundEnds(least, most);
  minimum_ = below;
  maximum_ = std::max(above, kLeastSpan * minimum_);
}

QSize LossPlot::sizeHint() const {
  return {560, 260};
}
QSize LossPlot::minimumSizeHint() const {
  return {360, 180};
}

QRectF LossPlot::outside() const {
  return QRectF(rect()).adjusted(0, 0, 0, -theme::kHalfSpace);
}

double LossPlot::epochsBefore(std::size_t curve) const {
  double before = 0;
  for (std::size_t i = 0; i < curve; ++i)
    before += curves_[i].epochs;
  return before;
}

QPointF LossPlot::pointAt(std::size_t curve, double epoch, double error) const {
  const Point place =
      view_.layOut(panel(), outside(), font()).at(epochsBefore(curve) + epoch, error);
  return {place.x, place.y};
}

void LossPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  view_.paint(painter, panel(), outside(), font());
}

Panel LossPlot::panel() const {
  const PlotTheme& theme = view_.themeFor(font());
  Panel panel;
  panel.title = tr("Error of reflectance by epoch").toStdString();
  panel.legend = {{tr("Training").toStdString(), firstCurveStroke(theme), {}},
                  {tr("Validation").toStdString(), secondCurveStroke(theme), {}}};
  panel.x.from = 0;
  panel.x.to = epochsBefore(curves_.size());
  panel.x.hasGrid = false;
  panel.y = logarithmicAxis(minimum_, maximum_, [](double error, double) {  //
    return percentWords(error);
  });
  panel.y.widest = percentWords(0.00012);
  for (std::size_t i = 0; i < curves_.size(); ++i)
    addCurve(panel, curves_[i], epochsBefore(i));
  const bool any = std::any_of(curves_.begin(), curves_.end(),
                               [](const LossCurve& curve) { return !curve.heldOut.isEmpty(); });
  if (!any) panel.message = tr("The curves begin after the first epoch").toStdString();
  return panel;
}

// Networks stand side by side: neighbours differ in tone and are parted by their names.
void LossPlot::addCurve(Panel& panel, const LossCurve& curve, double before) const {
  const PlotTheme& theme = view_.themeFor(font());
  const bool isOdd = panel.shades.size() % 2 == 1;
  panel.shades.push_back({before, before + curve.epochs, isOdd ? theme.outerShade : theme.shade,
                          curve.name.toStdString()});
  const double step = std::max(1.0, niceStep(curve.epochs, kMostEpochTicks));
  for (const double epoch : ticksWithin(0, curve.epochs, step)) {
    // The end of one network is the beginning of the next.
    if (epoch == 0 && before > 0) continue;
    panel.x.ticks.push_back(
        {before + epoch, QLocale().toString(static_cast<int>(epoch)).toStdString(), {}, false});
  }
  const auto add = [&](const QVector<double>& errors, const Stroke& stroke) {
    Curve shown;
    shown.stroke = stroke;
    // A line needs two points.
    if (errors.size() == 1) shown.marker = Marker{stroke.color, kEndRadius};
    for (int i = 0; i < errors.size(); ++i) {
      shown.x.push_back(before + i + 1);
      shown.y.push_back(canBeDrawn(errors[i]) ? errors[i] : std::nan(""));
    }
    panel.curves.push_back(shown);
  };
  add(curve.trained, firstCurveStroke(theme));
  add(curve.heldOut, secondCurveStroke(theme));
}

}  // namespace cutis
