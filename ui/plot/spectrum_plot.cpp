#include "ui/plot/spectrum_plot.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "ui/plot/pin_colors.h"
#include "ui/plot/window_theme.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kKeySamples = 5;
constexpr int kWheelNotch = 120;

QVector<double> onTheGrid(const QVector<double>& curve) {
  return curve.size() == kSampleCount ? curve : QVector<double>();
}

PlaceCurves onTheGrid(const PlaceCurves& curves) {
  return {onTheGrid(curves.original), onTheGrid(curves.edited), onTheGrid(curves.deviation)};
}

int nearestSample(double nm) {
  return static_cast<int>(std::lround((nm - kFirstWavelengthNm) / kWavelengthStepNm));
}

}  // namespace

SpectrumPlot::SpectrumPlot(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Spectrum"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  clear();
}

void SpectrumPlot::setPlace(const QString& heading, const PlaceCurves& curves,
                            const QVector<MeasuredChannel>& channels) {
  heading_ = heading;
  figure_.place = onTheGrid(curves);
  figure_.channels = channels;
  figureChanged();
}

void SpectrumPlot::setPins(const std::vector<PinnedCurves>& pins) {
  figure_.pins = pins;
  for (PinnedCurves& pin : figure_.pins)
    pin.curves = onTheGrid(pin.curves);
  figureChanged();
}

void SpectrumPlot::setReferences(const std::vector<NamedCurve>& references) {
  figure_.references.clear();
  std::copy_if(references.begin(), references.end(), std::back_inserter(figure_.references),
               [](const NamedCurve& curve) { return curve.values.size() == kSampleCount; });
  figureChanged();
}

void SpectrumPlot::setMeasured(const std::optional<Band>& measured) {
  figure_.measured = measured;
  update();
}

void SpectrumPlot::setParts(SpectrumQuantity quantity, const std::vector<NamedCurve>& parts) {
  figure_.quantity = quantity;
  figure_.parts = parts;
  figureChanged();
}

void SpectrumPlot::clear() {
  SpectrumFigure empty;
  empty.references = figure_.references;
  empty.quantity = figure_.quantity;
  figure_ = empty;
  heading_.clear();
  axis_.forget();
  figureChanged();
}

void SpectrumPlot::figureChanged() {
  const QString quantity = figure_.quantity == SpectrumQuantity::reflectance ? tr("Reflectance")
                           : figure_.quantity == SpectrumQuantity::absorption
                               ? tr("Absorption in mm⁻¹")
                               : tr("Contributions");
  figure_.title = heading_.isEmpty() ? quantity : tr("%1, %2").arg(quantity, heading_);
  axis_.see(largestValue(figure_));
  figure_.maximum = axis_.maximum();
  update();
  const bool isEmpty = !hasCurves(figure_);
  if (isEmpty != std::exchange(isEmpty_, isEmpty)) Q_EMIT emptinessChanged();
}

void SpectrumPlot::stepAxis(int count) {
  axis_.step(count);
  figureChanged();
}

QSize SpectrumPlot::sizeHint() const {
  return {640, 220};
}
QSize SpectrumPlot::minimumSizeHint() const {
  return {280, 140};
}

QRectF SpectrumPlot::outside() const {
  return QRectF(rect()).adjusted(theme::kSpace, theme::kSpace, 0, -theme::kHalfSpace);
}

const PlotTheme& SpectrumPlot::plotTheme() const {
  return view_.themeFor(font());
}

Panel SpectrumPlot::panel() const {
  return panelOf(figure_, {plotTheme(), localTickWords, pinColor, false, crosshair_, pointedAt_});
}

PanelLayout SpectrumPlot::layout() const {
  return view_.layOut(panel(), outside(), font());
}

QPointF SpectrumPlot::pointAt(double wavelengthNm, double reflectance) const {
  const Point place = layout().at(wavelengthNm, reflectance);
  return {place.x, place.y};
}

void SpectrumPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme::tones().panel);
  view_.paint(painter, panel(), outside(), font());
  if (hasFocus()) theme::drawFocusRing(painter, QRectF(rect()));
}

void SpectrumPlot::setCrosshair(std::optional<int> sample, std::optional<double> pointedAt) {
  if (sample) sample = std::clamp(*sample, 0, kSampleCount - 1);
  if (sample == crosshair_ && pointedAt == pointedAt_) return;
  crosshair_ = sample;
  pointedAt_ = pointedAt;
  update();
}

void SpectrumPlot::mouseMoveEvent(QMouseEvent* event) {
  const PanelLayout places = layout();
  const QPointF at = event->position();
  if (!places.area.holds(Point{at.x(), at.y()})) return setCrosshair({});
  setCrosshair(nearestSample(places.x.valueAt(at.x())), places.y.valueAt(at.y()));
}

void SpectrumPlot::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  axis_.setAutomatic();
  figureChanged();
}

// Away from oneself: the curves grow.
void SpectrumPlot::wheelEvent(QWheelEvent* event) {
  wheelRest_ += event->angleDelta().y();
  const int notches = wheelRest_ / kWheelNotch;
  wheelRest_ -= notches * kWheelNotch;
  if (notches != 0) stepAxis(-notches);
  event->accept();
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
    case Qt::Key_Up:
      return stepAxis(-1);
    case Qt::Key_Down:
      return stepAxis(1);
    case Qt::Key_Escape:
      if (crosshair_) return setCrosshair({});
      break;
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

}  // namespace cutis
