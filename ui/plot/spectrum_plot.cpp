#include "ui/plot/spectrum_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>

#include "core/spectra/grid.h"
#include "ui/plot/window_theme.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr double kHeadroom = 1.03;
constexpr int kKeySamples = 5;
constexpr double kPointRadius = 3;
constexpr double kBandDeviations = 2;
constexpr std::uint8_t kBandAlpha = 60;
constexpr double kCrosshairRadius = 4.5;
constexpr int kReflectanceSteps = 5;
constexpr int kWavelengthSteps = 7;
// The longest number on the axis of reflectance, so that the axis does not move from pixel to
// pixel.
constexpr char kWidestNumber[] = "0.000";

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

const std::vector<double>& gridNm() {
  static const std::vector<double> values = [] {
    std::vector<double> all;
    for (int i = 0; i < kSampleCount; ++i)
      all.push_back(wavelengthNm(i));
    return all;
  }();
  return values;
}

int nearestSample(double nm) {
  return static_cast<int>(std::lround((nm - kFirstWavelengthNm) / kWavelengthStepNm));
}

Shade shadeOf(const QString& name, const Band& band, Color color) {
  return {static_cast<double>(wavelengthNm(band.first)),
          static_cast<double>(wavelengthNm(band.last)), color, name.toStdString()};
}

}  // namespace

SpectrumPlot::SpectrumPlot(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Spectrum"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
}

void SpectrumPlot::setCurves(const QVector<double>& original, const QVector<double>& edited,
                             const QVector<double>& deviation) {
  original_ = onTheGrid(original);
  edited_ = onTheGrid(edited);
  deviation_ = original_.isEmpty() ? QVector<double>() : onTheGrid(deviation);
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
  maximum_ = most > 0 ? niceCeiling(kHeadroom * most, kReflectanceSteps) : 1;
  update();
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

Panel SpectrumPlot::emptyPanel() const {
  const PlotTheme& theme = plotTheme();
  Panel panel;
  panel.title =
      (heading_.isEmpty() ? tr("Reflectance") : tr("Reflectance, %1").arg(heading_)).toStdString();
  panel.shades = {shadeOf(tr("UV"), kUltravioletBand, theme.outerShade),
                  shadeOf(tr("Visible"), kVisibleBand, theme.shade),
                  shadeOf(tr("NIR"), kNearInfraredBand, theme.outerShade)};
  panel.x = linearAxis(kFirstWavelengthNm, kLastWavelengthNm, kWavelengthSteps);
  panel.x.unit = tr("nm").toStdString();
  panel.x.hasGrid = false;
  panel.y = linearAxis(0, maximum_, kReflectanceSteps, localTickWords);
  panel.y.widest = kWidestNumber;
  return panel;
}

Panel SpectrumPlot::panel() const {
  Panel panel = emptyPanel();
  if (original_.isEmpty() && edited_.isEmpty()) {
    panel.message = tr("Point at the skin to see its spectrum").toStdString();
    return panel;
  }
  if (crosshair_) {
    const double nm = wavelengthNm(*crosshair_);
    panel.cursor = Tick{nm, tr("%1 nm").arg(nm).toStdString(), {}, false};
  }
  addBand(panel);
  addCurve(panel, original_, tr("Original"), firstCurveStroke(plotTheme()));
  addCurve(panel, edited_, tr("Edited"), secondCurveStroke(plotTheme()));
  addMeasured(panel);
  return panel;
}

// With a point where the crosshair is.
void SpectrumPlot::addCurve(Panel& panel, const QVector<double>& values, const QString& name,
                            const Stroke& stroke) const {
  if (values.isEmpty()) return;
  panel.curves.push_back({gridNm(), {values.begin(), values.end()}, stroke, {}});
  panel.legend.push_back({legendText(name, values).toStdString(), stroke, {}});
  if (!crosshair_) return;
  PlotPoint point;
  point.x = wavelengthNm(*crosshair_);
  point.y = values[*crosshair_];
  point.marker = {stroke.color, kCrosshairRadius};
  panel.points.push_back(point);
}

// Where the original lies with 95 % probability.
void SpectrumPlot::addBand(Panel& panel) const {
  if (deviation_.isEmpty()) return;
  Ribbon band;
  band.x = gridNm();
  for (int i = 0; i < original_.size(); ++i) {
    band.low.push_back(std::max(original_[i] - kBandDeviations * deviation_[i], 0.0));
    band.high.push_back(original_[i] + kBandDeviations * deviation_[i]);
  }
  band.color = firstCurveStroke(plotTheme()).color.faded(kBandAlpha);
  panel.ribbons = {band};
}

void SpectrumPlot::addMeasured(Panel& panel) const {
  if (measured_.isEmpty()) return;
  const Marker marker = {plotTheme().ink, kPointRadius};
  for (const MeasuredChannel& channel : measured_) {
    PlotPoint point;
    point.x = channel.wavelengthNm;
    point.y = channel.reflectance;
    point.marker = marker;
    point.across = {channel.wavelengthNm - channel.halfWidthNm,
                    channel.wavelengthNm + channel.halfWidthNm};
    point.upwards = {channel.reflectance - channel.deviation,
                     channel.reflectance + channel.deviation};
    panel.points.push_back(point);
  }
  panel.legend.push_back({tr("Photograph").toStdString(), {marker.color, 1.0}, marker});
}

// With the value under the crosshair: there it hides no curve.
QString SpectrumPlot::legendText(const QString& name, const QVector<double>& curve) const {
  if (!crosshair_ || !std::isfinite(curve[*crosshair_])) return name;
  return name + ' ' + QLocale().toString(curve[*crosshair_], 'f', 4);
}

void SpectrumPlot::setCrosshair(std::optional<int> sample) {
  if (sample) sample = std::clamp(*sample, 0, kSampleCount - 1);
  if (sample == crosshair_) return;
  crosshair_ = sample;
  update();
}

void SpectrumPlot::mouseMoveEvent(QMouseEvent* event) {
  const PanelLayout places = layout();
  const double x = event->position().x();
  const bool isInside = places.area.left <= x && x <= places.area.right;
  const double nm = places.x.valueAt(x);
  setCrosshair(isInside ? std::optional(nearestSample(nm)) : std::nullopt);
}

QString SpectrumPlot::curvesText() const {
  if (original_.isEmpty()) return {};
  const std::pair<const char*, const QVector<double>&> columns[] = {
      {"original", original_}, {"edited", edited_}, {"deviation", deviation_}};
  QString text = "wavelength_nm";
  for (const auto& [name, curve] : columns) {
    if (!curve.isEmpty()) text += QString("\t%1").arg(name);
  }
  for (int sample = 0; sample < kSampleCount; ++sample) {
    text += QString("\n%1").arg(wavelengthNm(sample));
    for (const auto& [name, curve] : columns) {
      if (!curve.isEmpty()) text += QString("\t%1").arg(curve[sample], 0, 'g', 6);
    }
  }
  return text + '\n';
}

void SpectrumPlot::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setToolTipsVisible(true);
  QAction* copy = menu->addAction(tr("&Copy curves as text"));
  copy->setEnabled(!original_.isEmpty());
  copy->setToolTip(original_.isEmpty() ? tr("There is no curve; point at skin in the picture")
                                       : tr("A table for spreadsheets"));
  connect(copy, &QAction::triggered, this,
          [this] { QGuiApplication::clipboard()->setText(curvesText()); });
  menu->popup(event->globalPos());
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
