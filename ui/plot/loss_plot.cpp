#include "ui/plot/loss_plot.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include "ui/plot/axis_ticks.h"
#include "ui/plot/plot_title.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kMostEpochTicks = 5;
constexpr double kEndRadius = 2;
// An axis of less than this ratio would show noise as progress.
constexpr double kLeastSpan = 10;

bool canBeDrawn(double error) {
  return error > 0 && std::isfinite(error);
}

QString percentText(double error) {
  return LossPlot::tr("%1 %").arg(QLocale().toString(100 * error, 'g', 2));
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
  const auto ticks = logarithmicTicks(least / 10, 10 * most, 1000);
  minimum_ = *std::prev(std::upper_bound(ticks.begin(), ticks.end(), least));
  maximum_ = std::max(*std::lower_bound(ticks.begin(), ticks.end(), most), kLeastSpan * minimum_);
}

QSize LossPlot::sizeHint() const {
  return {560, 260};
}
QSize LossPlot::minimumSizeHint() const {
  return {360, 180};
}

QRectF LossPlot::area() const {
  const QFontMetricsF metrics(font());
  const double left = theme::kSpace + metrics.horizontalAdvance(percentText(0.00012));
  // Title line, then the names of the networks.
  const double top = 2 * (metrics.height() + theme::kHalfSpace) + 2;
  const double bottom = theme::kHalfSpace + metrics.height() + theme::kHalfSpace;
  return QRectF(rect()).adjusted(left, top, -theme::kDoubleSpace, -bottom);
}

QRectF LossPlot::band(std::size_t curve) const {
  double before = 0, all = 0;
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    if (i < curve) before += curves_[i].epochs;
    all += curves_[i].epochs;
  }
  const QRectF whole = area();
  return {whole.left() + whole.width() * before / all, whole.top(),
          whole.width() * curves_[curve].epochs / all, whole.height()};
}

QPointF LossPlot::pointAt(std::size_t curve, double epoch, double error) const {
  const QRectF place = band(curve);
  const double up = std::log(error / minimum_) / std::log(maximum_ / minimum_);
  return {place.left() + place.width() * epoch / curves_[curve].epochs,
          place.bottom() - place.height() * up};
}

void LossPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(font());
  for (std::size_t i = 0; i < curves_.size(); ++i)
    drawBand(painter, i);
  const bool any = std::any_of(curves_.begin(), curves_.end(),
                               [](const LossCurve& curve) { return !curve.heldOut.isEmpty(); });
  if (!any) {
    painter.setPen(theme::tones().dimText);
    painter.drawText(area(), Qt::AlignCenter, tr("The curves begin after the first epoch"));
    return;
  }
  drawErrors(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    drawCurve(painter, i, curves_[i].trained, firstCurvePen());
    drawCurve(painter, i, curves_[i].heldOut, secondCurvePen());
  }
  const QRectF whole = area();
  drawPlotTitle(painter, QRectF(whole.left(), 0, whole.width(), QFontMetricsF(font()).height()),
                tr("Error of reflectance by epoch"),
                {{tr("Learned from"), firstCurvePen()}, {tr("Held back"), secondCurvePen()}});
}

// Neighbours differ in tone and are parted by their names.
void LossPlot::drawBand(QPainter& painter, std::size_t curve) const {
  const theme::Tones& tones = theme::tones();
  const QFontMetricsF metrics(font());
  const QRectF below = band(curve);
  const double nameHeight = metrics.height() + 2;
  const QRectF above(below.left(), below.top() - nameHeight, below.width(), nameHeight);
  painter.fillRect(below.united(above), curve % 2 == 0 ? tones.plotBand : tones.plotOuterBand);
  painter.setPen(tones.dimText);
  painter.drawText(above, Qt::AlignCenter, curves_[curve].name);
  const int epochs = curves_[curve].epochs;
  const double step = std::max(1.0, niceStep(epochs, kMostEpochTicks));
  for (const double epoch : ticksWithin(0, epochs, step)) {
    // The end of one network is the beginning of the next.
    if (epoch == 0 && curve > 0) continue;
    const double x = below.left() + below.width() * epoch / epochs;
    painter.setPen(tones.line);
    painter.drawLine(QPointF(x, below.bottom()), QPointF(x, below.bottom() + theme::kHalfSpace));
    const QString text = QLocale().toString(static_cast<int>(epoch));
    const double width = metrics.horizontalAdvance(text) + 2;
    painter.setPen(tones.dimText);
    painter.drawText(
        QRectF(x - width / 2, below.bottom() + theme::kHalfSpace, width, metrics.height()),
        Qt::AlignCenter, text);
  }
}

void LossPlot::drawErrors(QPainter& painter) const {
  const theme::Tones& tones = theme::tones();
  const QRectF whole = area();
  const double textHeight = QFontMetricsF(font()).height();
  const int most = static_cast<int>(whole.height() / (1.6 * textHeight));
  for (const double error : logarithmicTicks(minimum_, maximum_, most)) {
    const double y = pointAt(0, 0, error).y();
    painter.setPen(tones.gridLine);
    painter.drawLine(QPointF(whole.left(), y), QPointF(whole.right(), y));
    painter.setPen(tones.dimText);
    painter.drawText(QRectF(0, y - textHeight / 2, whole.left() - theme::kSpace, textHeight),
                     Qt::AlignRight | Qt::AlignVCenter, percentText(error));
  }
}

void LossPlot::drawCurve(QPainter& painter, std::size_t curve, const QVector<double>& errors,
                         const QPen& pen) const {
  QPainterPath path;
  bool drawing = false;
  for (int i = 0; i < errors.size(); ++i) {
    if (!canBeDrawn(errors[i])) {
      drawing = false;
      continue;
    }
    const QPointF point = pointAt(curve, i + 1, errors[i]);
    drawing ? path.lineTo(point) : path.moveTo(point);
    drawing = true;
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen);
  painter.drawPath(path);
  if (errors.size() != 1 || !drawing) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(pen.color());
  painter.drawEllipse(path.currentPosition(), kEndRadius, kEndRadius);
}

}  // namespace cutis
