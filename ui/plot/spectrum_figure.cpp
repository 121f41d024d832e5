#include "ui/plot/spectrum_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <QCoreApplication>

#include "ui/plot/window_theme.h"

namespace cutis {
namespace {

constexpr double kDeviations = 2;
constexpr std::uint8_t kBandAlpha = 60;
constexpr double kBandSample = 8;  // thickness of a band in the legend
constexpr double kPointRadius = 3.5;
constexpr double kModelledRadius = 5.5;
constexpr double kCrosshairRadius = 4.5;
constexpr double kPinWidth = 1.6;
constexpr int kReflectanceSteps = 5;
constexpr double kLeastAbsorption = 0.1;  // mm⁻¹
constexpr int kWavelengthSteps = 7;
// Of the letter on the curve of the first pin, and how far apart those of the next are.
constexpr int kFirstLetterNm = 620;
constexpr int kLetterStepNm = 44;
constexpr int kLetters = 8;
constexpr int kLongestName = 24;
// The longest number on the axis of reflectance, so that the axis does not move from place to
// place.
constexpr char kWidestNumber[] = "0.000";
// Of the height of a plot: what is less cannot be told from the axis.
constexpr double kUnseenShare = 0.01;
constexpr char kWidestContribution[] = "−0.00";

QString tr(const char* text) {
  return QCoreApplication::translate("SpectrumFigure", text);
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

// Whole lines become dashed and dashed ones dotted where nothing was measured.
Stroke beyondMeasured(Stroke stroke) {
  const bool isWhole = stroke.dash == 0.0;
  stroke.dash = isWhole ? 4.0 : 1.5;
  stroke.gap = isWhole ? 3.0 : 3.5;
  return stroke;
}

QString shortName(const QString& name) {
  return name.size() <= kLongestName ? name : name.left(kLongestName - 1) + "…";
}

QString titleOf(const PinnedCurves& pin) {
  return pin.name.isEmpty() ? pin.letter : pin.letter + ' ' + shortName(pin.name);
}

double largest(const QVector<double>& curve) {
  double most = 0;
  for (const double value : curve) {
    if (std::isfinite(value)) most = std::max(most, value);
  }
  return most;
}

double smallest(const QVector<double>& curve) {
  double least = 0;
  for (const double value : curve) {
    if (std::isfinite(value)) least = std::min(least, value);
  }
  return least;
}

// The panel of a figure while it is put together.
class FigurePanel {
 public:
  FigurePanel(const SpectrumFigure& figure, const FigureLook& look)
      : figure_(figure), look_(look) {}

  Panel make() {
    addAxes();
    addShades();
    if (figure_.quantity != SpectrumQuantity::reflectance) return withParts();
    if (!hasCurves(figure_)) {
      panel_.message = tr("Point at the skin to see its spectrum").toStdString();
      return panel_;
    }
    addCrosshair();
    addPlace(figure_.place, firstCurveStroke(look_.theme), secondCurveStroke(look_.theme));
    for (const PinnedCurves& pin : figure_.pins)
      addPin(pin);
    for (std::size_t i = 0; i < figure_.references.size(); ++i)
      addReference(figure_.references[i], i);
    addChannels();
    addUnmeasured();
    return panel_;
  }

 private:
  void addAxes() {
    panel_.title = figure_.title.toStdString();
    panel_.x = linearAxis(kFirstWavelengthNm, kLastWavelengthNm, kWavelengthSteps);
    panel_.x.unit = tr("nm").toStdString();
    panel_.x.hasGrid = false;
    addAxisUpwards();
    if (look_.isPrinted) panel_.x.title = tr("Wavelength").toStdString();
  }

  void addAxisUpwards() {
    switch (figure_.quantity) {
      case SpectrumQuantity::reflectance:
        return addAxisOfReflectance();
      case SpectrumQuantity::absorption:
        panel_.y = absorptionAxis();
        return;
      case SpectrumQuantity::contributions:
        return addAxisOfContributions();
    }
  }

  void addAxisOfReflectance() {
    panel_.y = linearAxis(0, figure_.maximum, kReflectanceSteps, look_.words);
    panel_.y.widest = kWidestNumber;
    if (look_.isPrinted) panel_.y.title = tr("Reflectance (perfect diffuser = 1)").toStdString();
  }

  // Skin may reflect more with a chromophore than without it: in the infrared blood takes the place
  // of water.
  void addAxisOfContributions() {
    double least = 0, most = 0;
    for (const NamedCurve& part : figure_.parts) {
      least = std::min(least, smallest(part.values));
      most = std::max(most, largest(part.values));
    }
    if (-least < kUnseenShare * most) least = 0;
    const double step = niceStep(most - least, kReflectanceSteps);
    panel_.y =
        linearAxis(step * std::floor(least / step), step * std::max(std::ceil(most / step), 1.0),
                   kReflectanceSteps + 2, look_.words);
    panel_.y.widest = kWidestContribution;
    if (least < 0) panel_.levels.push_back({0, {look_.theme.muted, 1.0}, {}});
    if (look_.isPrinted)
      panel_.y.title = tr("Reflectance taken (perfect diffuser = 1)").toStdString();
  }

  Axis absorptionAxis() const {
    double least = kLeastAbsorption, most = kLeastAbsorption;
    for (const NamedCurve& part : figure_.parts) {
      for (const double value : part.values) {
        if (std::isfinite(value)) most = std::max(most, value);
        if (value > 0) least = std::min(least, value);
      }
    }
    Axis axis = decadeAxis(std::max(least, kLeastAbsorption / 10), 1.01 * most);
    if (look_.isPrinted) axis.title = tr("Absorption, mm⁻¹").toStdString();
    return axis;
  }

  // In strokes that differ in colour and in dashes.
  Panel withParts() {
    if (figure_.parts.empty()) {
      panel_.message = tr("Point at the skin to see its spectrum").toStdString();
      return panel_;
    }
    addCursor();
    const SeriesColors& colors = look_.theme.series;
    const std::array<Stroke, 4> strokes = {{{colors.orange, 2.0},
                                            {colors.purple, 2.0, 9.0, 4.0},
                                            {colors.blue, 2.0, 5.0, 3.0},
                                            {colors.green, 2.0, 2.0, 2.5}}};
    for (std::size_t i = 0; i < figure_.parts.size(); ++i) {
      const NamedCurve& part = figure_.parts[i];
      const Stroke& stroke = strokes[i % strokes.size()];
      panel_.curves.push_back({gridNm(), {part.values.begin(), part.values.end()}, stroke, {}});
      panel_.legend.push_back({withValue(part.name, part.values).toStdString(), stroke, {}});
      addCrossing(part.values, stroke.color, {});
    }
    return panel_;
  }

  void addBand(const QString& name, const Band& band, Color color) {
    panel_.shades.push_back(
        {wavelengthNm(band.first), wavelengthNm(band.last), color, name.toStdString()});
  }

  void addShades() {
    const PlotTheme& theme = look_.theme;
    addBand(tr("UV"), kUltravioletBand, theme.outerShade);
    addBand(tr("Visible"), kVisibleBand, theme.shade);
    addBand(tr("NIR"), kNearInfraredBand, theme.outerShade);
    if (!figure_.measured) return;
    addBand({}, {0, figure_.measured->first}, theme.outerShade);
    addBand({}, {figure_.measured->last, kSampleCount - 1}, theme.outerShade);
  }

  void addCursor() {
    if (!look_.crosshair) return;
    const double nm = wavelengthNm(*look_.crosshair);
    panel_.cursor = Tick{nm, tr("%1 nm").arg(nm).toStdString(), {}, false};
  }

  void addCrosshair() {
    addCursor();
    if (!look_.pointedAt) return;
    panel_.levels.push_back({*look_.pointedAt,
                             {look_.theme.muted, 1.0, 2.0, 3.0},
                             look_.words(*look_.pointedAt, figure_.maximum / 500)});
  }

  // One curve in the parts that were measured and those that were not.
  void addLine(const QVector<double>& values, const Stroke& stroke) {
    const Band seen = figure_.measured.value_or(Band{});
    const auto add = [&](int first, int last, const Stroke& partStroke) {
      if (last <= first) return;
      Curve curve;
      curve.stroke = partStroke;
      curve.x.assign(gridNm().begin() + first, gridNm().begin() + last + 1);
      curve.y.assign(values.begin() + first, values.begin() + last + 1);
      panel_.curves.push_back(std::move(curve));
    };
    add(0, seen.first, beyondMeasured(stroke));
    add(seen.first, seen.last, stroke);
    add(seen.last, kSampleCount - 1, beyondMeasured(stroke));
  }

  // With the value under the crosshair beside the name: there it hides no curve.
  QString withValue(const QString& name, const QVector<double>& values) const {
    if (!look_.crosshair || !std::isfinite(values[*look_.crosshair])) return name;
    return name + ' ' + QString::fromStdString(look_.words(values[*look_.crosshair], 1e-4));
  }

  void addCrossing(const QVector<double>& values, Color color, const std::string& label) {
    if (!look_.crosshair) return;
    PlotPoint point;
    point.x = wavelengthNm(*look_.crosshair);
    point.y = values[*look_.crosshair];
    point.marker = {color, kCrosshairRadius};
    point.label = label;
    panel_.points.push_back(point);
  }

  void addPlace(const PlaceCurves& place, const Stroke& first, const Stroke& second) {
    addBandOf(place, first.color);
    const auto add = [&](const QVector<double>& values, const QString& name, const Stroke& stroke) {
      if (values.isEmpty()) return;
      addLine(values, stroke);
      panel_.legend.push_back({withValue(name, values).toStdString(), stroke, {}});
      addCrossing(values, stroke.color, {});
    };
    add(place.original, tr("Original"), first);
    add(place.edited, tr("Edited"), second);
    if (place.original.isEmpty() || place.deviation.isEmpty()) return;
    panel_.legend.push_back(
        {tr("95 %").toStdString(), {first.color.faded(kBandAlpha), kBandSample}, {}});
  }

  void addBandOf(const PlaceCurves& place, Color color) {
    if (place.original.isEmpty() || place.deviation.isEmpty()) return;
    Ribbon band;
    band.x = gridNm();
    for (int i = 0; i < kSampleCount; ++i) {
      band.low.push_back(std::max(place.original[i] - kDeviations * place.deviation[i], 0.0));
      band.high.push_back(place.original[i] + kDeviations * place.deviation[i]);
    }
    band.color = color.faded(kBandAlpha);
    panel_.ribbons.push_back(std::move(band));
  }

  // The letter stands on the curve, on that of the edited skin where there is one; in a dock, which
  // has no room to give away, that alone says whose it is.
  void addPin(const PinnedCurves& pin) {
    if (pin.curves.original.isEmpty()) return;
    const Color color = look_.pinColor(pin.number);
    const Stroke stroke = {color, kPinWidth};
    const Stroke editedStroke = {color, kPinWidth, 8.0, 5.0};
    const bool isEdited = !pin.curves.edited.isEmpty();
    addBandOf(pin.curves, color);
    addLine(pin.curves.original, stroke);
    if (isEdited) addLine(pin.curves.edited, editedStroke);
    const QVector<double>& shown = isEdited ? pin.curves.edited : pin.curves.original;
    if (look_.isPrinted || !pin.name.isEmpty())
      panel_.legend.push_back({titleOf(pin).toStdString(), isEdited ? editedStroke : stroke, {}});
    if (look_.crosshair) {
      return addCrossing(shown, color, withValue(pin.letter, shown).toStdString());
    }
    const int nm = kFirstLetterNm + kLetterStepNm * (pin.number % kLetters);
    const int sample = (nm - kFirstWavelengthNm) / kWavelengthStepNm;
    PlotPoint letter;
    letter.x = wavelengthNm(sample);
    letter.y = shown[sample];
    letter.marker = {color, 2.0};
    letter.label = pin.letter.toStdString();
    panel_.points.push_back(letter);
  }

  // Grey, each with dashes of its own.
  void addReference(const NamedCurve& reference, std::size_t index) {
    const Stroke stroke = {look_.theme.series.grey, 1.5,
                           10.0 - 2.0 * static_cast<double>(index % 4),
                           2.0 + static_cast<double>(index % 4)};
    panel_.curves.push_back(
        {gridNm(), {reference.values.begin(), reference.values.end()}, stroke, {}});
    panel_.legend.push_back(
        {withValue(shortName(reference.name), reference.values).toStdString(), stroke, {}});
  }

  // What was measured as a disc with its bars, what the curve gives there as a ring around it.
  void addChannels() {
    if (figure_.channels.isEmpty() || figure_.place.original.isEmpty()) return;
    const Marker measured = {look_.theme.ink, kPointRadius};
    const Marker modelled = {firstCurveStroke(look_.theme).color, kModelledRadius, false};
    for (const MeasuredChannel& channel : figure_.channels) {
      PlotPoint ring;
      ring.x = channel.wavelengthNm;
      ring.y = channel.modelled;
      ring.marker = modelled;
      panel_.points.push_back(ring);
    }
    for (const MeasuredChannel& channel : figure_.channels) {
      PlotPoint disc;
      disc.x = channel.wavelengthNm;
      disc.y = channel.reflectance;
      disc.marker = measured;
      disc.across = {channel.wavelengthNm - channel.halfWidthNm,
                     channel.wavelengthNm + channel.halfWidthNm};
      disc.upwards = {channel.reflectance - kDeviations * channel.deviation,
                      channel.reflectance + kDeviations * channel.deviation};
      panel_.points.push_back(disc);
    }
    panel_.legend.push_back({tr("Photograph").toStdString(), {measured.color, 1.0}, measured});
    panel_.legend.push_back({tr("Curve there").toStdString(), kNoStroke, modelled});
  }

  void addUnmeasured() {
    if (!figure_.measured) return;
    panel_.legend.push_back(
        {tr("Extrapolated").toStdString(), beyondMeasured({look_.theme.muted, 2.0}), {}});
  }

  const SpectrumFigure& figure_;
  const FigureLook& look_;
  Panel panel_;
};

}  // namespace

bool hasCurves(const SpectrumFigure& figure) {
  if (figure.quantity != SpectrumQuantity::reflectance) return !figure.parts.empty();
  return !figure.place.original.isEmpty() || !figure.place.edited.isEmpty() ||
         !figure.pins.empty() || !figure.references.empty();
}

double largestValue(const SpectrumFigure& figure) {
  double most = std::max(largest(figure.place.original), largest(figure.place.edited));
  for (const PinnedCurves& pin : figure.pins)
    most = std::max({most, largest(pin.curves.original), largest(pin.curves.edited)});
  for (const NamedCurve& reference : figure.references)
    most = std::max(most, largest(reference.values));
  for (const MeasuredChannel& channel : figure.channels) {
    const double end = channel.reflectance + kDeviations * channel.deviation;
    if (std::isfinite(end)) most = std::max(most, end);
  }
  return most;
}

Panel panelOf(const SpectrumFigure& figure, const FigureLook& look) {
  return FigurePanel(figure, look).make();
}

}  // namespace cutis
