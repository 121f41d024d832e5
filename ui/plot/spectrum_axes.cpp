#include "ui/plot/spectrum_axes.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include "core/spectra/grid.h"
#include "ui/plot/axis_ticks.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kTickNm = 100;

QString translated(const char* text) {
  return QCoreApplication::translate("cutis::SpectrumPlot", text);
}

QString withUnit(double nm) {
  return translated("%1 nm").arg(nm);
}

}  // namespace

SpectrumAxes SpectrumAxes::within(const QRectF& outside, double maximum, const QFont& font) {
  const QFontMetricsF metrics(font);
  const double left = theme::kSpace + metrics.horizontalAdvance("0.000") + theme::kSpace;
  // Title line, then the names of the bands.
  const double top = theme::kSpace + 2 * (metrics.height() + theme::kHalfSpace) + 2;
  const double bottom = theme::kHalfSpace + metrics.height() + theme::kSpace;
  return {outside.adjusted(left, top, -theme::kDoubleSpace, -bottom), maximum, font};
}

QPointF SpectrumAxes::pointAt(double wavelengthNm, double reflectance) const {
  const double across =
      (wavelengthNm - kFirstWavelengthNm) / (kLastWavelengthNm - kFirstWavelengthNm);
  return {area.left() + area.width() * across,
          area.bottom() - area.height() * reflectance / maximum};
}

std::optional<int> SpectrumAxes::sampleAt(double x) const {
  const double across = (x - area.left()) / area.width();
  if (!(across >= 0 && across <= 1)) return {};
  return static_cast<int>(std::lround(across * (kSampleCount - 1)));
}

void SpectrumAxes::drawBands(QPainter& painter) const {
  struct NamedBand {
    const char* name;
    Band band;
    QColor color;
  };
  const theme::Tones& tones = theme::tones();
  const NamedBand bands[] = {
      {QT_TRANSLATE_NOOP("cutis::SpectrumPlot", "UVA"), kUltravioletBand, tones.plotOuterBand},
      {QT_TRANSLATE_NOOP("cutis::SpectrumPlot", "Visible"), kVisibleBand, tones.plotBand},
      {QT_TRANSLATE_NOOP("cutis::SpectrumPlot", "NIR"), kNearInfraredBand, tones.plotOuterBand}};
  const double nameHeight = QFontMetricsF(font).height() + 2;
  for (const auto& [name, band, color] : bands) {
    const QRectF below(pointAt(wavelengthNm(band.first), maximum),
                       pointAt(wavelengthNm(band.last), 0));
    const QRectF above(below.left(), below.top() - nameHeight, below.width(), nameHeight);
    painter.fillRect(below.united(above), color);
    painter.setPen(tones.dimText);
    painter.drawText(above, Qt::AlignCenter, translated(name));
  }
}

void SpectrumAxes::drawReflectances(QPainter& painter) const {
  const theme::Tones& tones = theme::tones();
  const double textHeight = QFontMetricsF(font).height();
  const double step = niceStep(maximum, kMostReflectanceSteps);
  // Every second number where the lines are closer than the text is high.
  const int every = area.height() * step / maximum < 1.3 * textHeight ? 2 : 1;
  int index = 0;
  for (const double value : ticksWithin(0, maximum, step)) {
    const double y = pointAt(kFirstWavelengthNm, value).y();
    painter.setPen(value > 0 ? tones.gridLine : tones.line);
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    if (index++ % every != 0) continue;
    const QRectF place(0, y - textHeight / 2, area.left() - theme::kSpace, textHeight);
    painter.setPen(tones.dimText);
    painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, tickText(value, step));
  }
}

void SpectrumAxes::drawWavelengths(QPainter& painter, std::optional<double> marked) const {
  const theme::Tones& tones = theme::tones();
  const QFontMetricsF metrics(font);
  const double rightEnd = area.right() + theme::kSpace;
  const auto placeOf = [&](double nm, const QString& text, double padding) {
    const double width = metrics.horizontalAdvance(text) + 2 + 2 * padding;
    const QPointF foot = pointAt(nm, 0);
    return QRectF(std::min(foot.x() - width / 2, rightEnd - width), foot.y() + theme::kHalfSpace,
                  width, metrics.height() + 2);
  };
  QRectF frame;
  if (marked) frame = placeOf(*marked, withUnit(*marked), theme::kHalfSpace);
  const QRectF last = placeOf(kLastWavelengthNm, withUnit(kLastWavelengthNm), 0);
  for (int nm = kFirstWavelengthNm; nm <= kLastWavelengthNm; nm += kTickNm) {
    const QPointF foot = pointAt(nm, 0);
    painter.setPen(tones.line);
    painter.drawLine(foot, foot + QPointF(0, theme::kHalfSpace));
    const QString text = nm == kLastWavelengthNm ? withUnit(nm) : QString::number(nm);
    const QRectF place = placeOf(nm, text, 0);
    // In a narrow plot the last number, which has the unit, stands where its neighbour would.
    if (place.intersects(frame) || (nm != kLastWavelengthNm && place.intersects(last))) continue;
    painter.setPen(tones.dimText);
    painter.drawText(place, Qt::AlignCenter, text);
  }
  if (!marked) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(tones.line);
  painter.setBrush(tones.field);
  painter.drawRoundedRect(frame, theme::kCornerRadius, theme::kCornerRadius);
  painter.setPen(tones.text);
  painter.drawText(frame, Qt::AlignCenter, withUnit(*marked));
  painter.restore();
}

}  // namespace cutis
