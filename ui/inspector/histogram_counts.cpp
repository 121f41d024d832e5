#include "ui/inspector/histogram_counts.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLocale>

#include "core/maths/quantile.h"

namespace cutis {
namespace {

constexpr std::size_t kParts = 128;
constexpr double kShareBelowEnd = 0.999;

QString tr(const char* text) {
  return QCoreApplication::translate("HistogramCounts", text);
}

std::vector<float> valuesOf(const PictureBuffer& pixels, std::size_t channel) {
  std::vector<float> values;
  for (std::size_t i = 0; i < pixels.present.size(); ++i) {
    const float value = pixels.channels[channel][i];
    if (pixels.present[i] && std::isfinite(value)) values.push_back(value);
  }
  return values;
}

// What lies beyond the ends is counted at them.
std::vector<double> countsOf(const std::vector<float>& values, double from, double to) {
  std::vector<double> counts(kParts);
  for (const float value : values) {
    const double place = kParts * (double{value} - from) / (to - from);
    const auto last = static_cast<double>(kParts - 1);
    ++counts[static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, last))];
  }
  return counts;
}

double endOf(std::vector<float> values, double least) {
  if (values.empty()) return least;
  return std::max(least, double{quantileOf(values, kShareBelowEnd)});
}

}  // namespace

HistogramSpec histogramOf(const ViewPart& part, const ViewDescription& view, const QString& name,
                          std::size_t pixels) {
  HistogramSpec spec;
  const bool isColor = !view.scale && part.pixels.channels.size() == 3;
  spec.axis = isColor ? tr("linear value, Rec.709") : name;
  spec.unit = isColor ? QString() : view.unit;
  spec.to = isColor ? 1.0 : 1e-4;
  std::size_t counted = 0;
  std::vector<std::vector<float>> channels;
  for (std::size_t c = 0;
       c < (isColor ? 3u : std::min<std::size_t>(1, part.pixels.channels.size())); ++c) {
    channels.push_back(valuesOf(part.pixels, c));
    counted = std::max(counted, channels.back().size());
    spec.to = std::max(spec.to, endOf(channels.back(), spec.to));
  }
  const QString names[] = {tr("red"), tr("green"), tr("blue")};
  constexpr Color kColors[] = {Color::rgb(0xe8756a), Color::rgb(0x7cc47f), Color::rgb(0x7aa7e8)};
  for (std::size_t c = 0; c < channels.size(); ++c) {
    spec.curves.push_back({isColor ? names[c] : QString(), isColor ? kColors[c] : kNoColor,
                           countsOf(channels[c], spec.from, spec.to)});
  }
  const QLocale locale;
  const QString what = isColor               ? tr("%1, linear value (Rec.709)").arg(name)
                       : spec.unit.isEmpty() ? name
                                             : tr("%1, %2").arg(name, spec.unit);
  spec.title = tr("%1: %2 of %3 pixels")
                   .arg(what, locale.toString(static_cast<qulonglong>(counted)),
                        locale.toString(static_cast<qulonglong>(pixels)));
  return spec;
}

}  // namespace cutis
