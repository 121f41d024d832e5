#include "ui/plot/spectrum_plot.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include "core/spectra/grid.h"
#include "ui/plot/axis_ticks.h"
#include "ui/plot/plot_title.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr double kHeadroom = 1.03;
constexpr int kKeySamples = 5;
constexpr double kPointRadius = 3;

double largest(const QVector<double>& curve) {
  double most = 0;
  for (const double value : curve) {
    if (std::isfinite(value)) most = std::max(most, value);
  }
  return most;
}

QVector<double> onTheGrid(const QVector<double>& curve) {
  return curve.size() == kSampleCount ? curve : QVector<double>();
}

}  // namespace

SpectrumPlot::SpectrumPlot(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Spectrum"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
}

void SpectrumPlot::setCurves(const QVector<double>& original, const QVector<double>& edited) {
  original_ = onTheGrid(original);
  edited_ = onTheGrid(edited);
  fitAxis();
}

void SpectrumPlot::setMeasured(const QVector<MeasuredChannel>& channels) {
  measured_ = channels;
  fitAxis();
}

void SpectrumPlot::setHeading(const QString& heading) {
  heading_ = heading;
  update();
}

void SpectrumPlot::clear() {
  heading_.clear();
  measured_.clear();
  setCurves({}, {});
}

void SpectrumPlot::fitAxis() {
  double most = std::max(largest(original_), largest(edited_));
  for (const MeasuredChannel& channel : measured_) {
    const double end = channel.reflectance + channel.deviation;
    if (std::isfinite(end)) most = std::max(most, end);
  }
  maximum_ = most > 0 ? niceCeiling(kHeadroom * most, kMostReflectanceSteps) : 1;
  update();
}

QSize SpectrumPlot::sizeHint() const {
  return {640, 220};
}
QSize SpectrumPlot::minimumSizeHint() const {
  return {320, 140};
}

SpectrumAxes SpectrumPlot::axes() const {
  return SpectrumAxes::within(QRectF(rect()), maximum_, font());
}

QPointF SpectrumPlot::pointAt(double wavelengthNm, double reflectance) const {
  return axes().pointAt(wavelengthNm, reflectance);
}

void SpectrumPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(font());
  painter.fillRect(rect(), theme::tones().panel);
  const SpectrumAxes frame = axes();
  frame.drawBands(painter);
  if (original_.isEmpty() && edited_.isEmpty()) {
    frame.drawWavelengths(painter, {});
    painter.setPen(theme::tones().text);
    painter.drawText(frame.area, Qt::AlignCenter, tr("Point at the skin to see its spectrum"));
  } else {
    frame.drawReflectances(painter);
    frame.drawWavelengths(painter, markedNm());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(frame.area.adjusted(0, -1, 0, 1));
    drawCurve(painter, original_, firstCurvePen());
    drawCurve(painter, edited_, secondCurvePen());
    drawMeasured(painter);
    painter.restore();
    drawTitleLine(painter);
    drawCrosshair(painter);
  }
  if (hasFocus()) theme::drawFocusRing(painter, QRectF(rect()));
}

void SpectrumPlot::drawCurve(QPainter& painter, const QVector<double>& curve,
                             const QPen& pen) const {
  QPainterPath path;
  bool drawing = false;
  for (int i = 0; i < curve.size(); ++i) {
    if (!std::isfinite(curve[i])) {
      drawing = false;
      continue;
    }
    const QPointF point = pointAt(wavelengthNm(i), curve[i]);
    drawing ? path.lineTo(point) : path.moveTo(point);
    drawing = true;
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen);
  painter.drawPath(path);
}

void SpectrumPlot::drawMeasured(QPainter& painter) const {
  for (const MeasuredChannel& channel : measured_) {
    if (!std::isfinite(channel.reflectance)) continue;
    const QPointF middle = pointAt(channel.wavelengthNm, channel.reflectance);
    const auto bar = [&](double nm, double reflectance) {
      painter.drawLine(pointAt(channel.wavelengthNm - nm, channel.reflectance - reflectance),
                       pointAt(channel.wavelengthNm + nm, channel.reflectance + reflectance));
    };
    painter.setPen(QPen(theme::tones().text, 1));
    bar(channel.halfWidthNm, 0);
    bar(0, channel.deviation);
    painter.setBrush(theme::tones().text);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(middle, kPointRadius, kPointRadius);
  }
}

std::optional<double> SpectrumPlot::markedNm() const {
  if (!crosshair_) return {};
  return wavelengthNm(*crosshair_);
}

// With the value under the crosshair: there it hides no curve.
QString SpectrumPlot::legendText(const QString& name, const QVector<double>& curve) const {
  if (!crosshair_ || !std::isfinite(curve[*crosshair_])) return name;
  return name + ' ' + QLocale().toString(curve[*crosshair_], 'f', 4);
}

void SpectrumPlot::drawTitleLine(QPainter& painter) const {
  std::vector<LegendEntry> legend;
  if (!original_.isEmpty()) {
    legend.push_back({legendText(tr("Original"), original_), firstCurvePen()});
  }
  if (!edited_.isEmpty()) legend.push_back({legendText(tr("Edited"), edited_), secondCurvePen()});
  if (!measured_.isEmpty()) {
    legend.push_back({tr("Photograph"), QPen(theme::tones().text, 1), kPointRadius - 0.5});
  }
  const QString heading =
      heading_.isEmpty() ? tr("Reflectance") : tr("Reflectance, %1").arg(heading_);
  const QRectF area = axes().area;
  const QRectF line(area.left(), theme::kSpace, area.width(), QFontMetricsF(font()).height());
  drawPlotTitle(painter, line, heading, legend);
}

void SpectrumPlot::drawCrosshair(QPainter& painter) const {
  if (!crosshair_) return;
  const theme::Tones& tones = theme::tones();
  const QRectF area = axes().area;
  const double nm = wavelengthNm(*crosshair_);
  const double x = pointAt(nm, 0).x();
  painter.setPen(QPen(tones.dimText, 1));
  painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));

  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const auto mark = [&](const QVector<double>& curve, const QColor& color) {
    if (curve.isEmpty() || !std::isfinite(curve[*crosshair_])) return;
    painter.setPen(QPen(tones.field, 1.5));
    painter.setBrush(color);
    painter.drawEllipse(pointAt(nm, curve[*crosshair_]), 4, 4);
  };
  mark(original_, tones.original);
  mark(edited_, tones.edited);
  painter.restore();
}

void SpectrumPlot::setCrosshair(std::optional<int> sample) {
  if (sample) sample = std::clamp(*sample, 0, kSampleCount - 1);
  if (sample == crosshair_) return;
  crosshair_ = sample;
  update();
}

void SpectrumPlot::mouseMoveEvent(QMouseEvent* event) {
  setCrosshair(axes().sampleAt(event->position().x()));
}

void SpectrumPlot::leaveEvent(QEvent*) {
  setCrosshair({});
}

void SpectrumPlot::keyPressEvent(QKeyEvent* event) {
  const int far = event->modifiers() & Qt::ShiftModifier ? 1 : kKeySamples;
  const int now = crosshair_.value_or(kSampleCount / 2);
  switch (event->key()) {
    case Qt::Key_Left:
      return setCrosshair(now - far);
    case Qt::Key_Right:
      return setCrosshair(now + far);
    case Qt::Key_Home:
      return setCrosshair(0);
    case Qt::Key_End:
      return setCrosshair(kSampleCount - 1);
    case Qt::Key_Escape:
      if (crosshair_) return setCrosshair({});
      break;
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

}  // namespace cutis
