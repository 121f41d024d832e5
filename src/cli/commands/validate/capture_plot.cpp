#include "src/cli/commands/validate/capture_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "src/report/plot/page.h"

namespace cutis {
namespace {

constexpr double kCapturePanelHeight = 200.0;
constexpr double kSmallestError = 1e-5;
constexpr double kErrorTickNm = 100.0, kErrorFineTickNm = 20.0;
constexpr double kWideNm = 450.0;

// Results that share a panel: of one set, learned alike.
struct PanelKey {
  std::size_t set = 0;
  bool isShipped = false;
  bool isFold = false;
  std::size_t learnedFrom = 0;

  bool operator==(const PanelKey&) const = default;
};

PanelKey keyOf(const CaptureResult& result) {
  const bool isShipped = result.scheme == CaptureScheme::asShipped ||
                         result.scheme == CaptureScheme::withoutDiscrepancy;
  return {result.set, isShipped, result.scheme == CaptureScheme::foldLeftOut, result.learnedFrom};
}

Stroke strokeOf(const CaptureResult& result) {
  const SeriesColors& series = printTheme().series;
  const std::array<Color, 3> profiles = {series.orange, series.green, series.purple};
  switch (result.estimator) {
    case CaptureEstimator::wiener:
      return {series.blue, 1.8};
    case CaptureEstimator::quadraticWiener:
      return {series.blue, 1.8, 6.0, 4.0};
    case CaptureEstimator::refined:
      break;
  }
  const Color color = profiles[result.model % profiles.size()];
  if (result.scheme == CaptureScheme::withoutDiscrepancy) return {color, 1.8, 2.0, 3.0};
  return {color, 1.8};
}

std::string legendOf(const CaptureResult& result, const CaptureNames& names) {
  if (result.scheme == CaptureScheme::withoutDiscrepancy) {
    return nameOf(result, names) + ", without discrepancy";
  }
  return nameOf(result, names);
}

std::string titleOf(const CaptureResult& result, const CaptureNames& names) {
  const std::string& set = names.sets[result.set];
  if (keyOf(result).isShipped) return set + ", profiles as they are";
  if (result.scheme == CaptureScheme::setLeftOut) {
    return set + ", learned from " + names.sets[result.learnedFrom];
  }
  if (result.scheme == CaptureScheme::foldLeftOut) {
    return set + ", learned from all but a few of the people";
  }
  return set + ", learned from the other half of the people";
}

Axis errorAxis(const std::vector<CaptureResult>& results) {
  double least = 1.0, most = kSmallestError;
  for (const CaptureResult& result : results) {
    for (const double error : result.medianErrors) {
      if (std::isnan(error)) continue;
      least = std::min(least, std::max(error, kSmallestError));
      most = std::max(most, error);
    }
  }
  const auto [from, to] = roundEnds(std::min(least, most), most);
  Axis axis = logarithmicAxis(from, to);
  axis.title = "median error";
  return axis;
}

Axis axisOf(const std::vector<double>& wavelengthsNm) {
  const double from = wavelengthsNm.front(), to = wavelengthsNm.back();
  const double step = to - from < kWideNm ? kErrorFineTickNm : kErrorTickNm;
  return linearAxis(from, to, static_cast<int>(std::ceil((to - from) / step)));
}

std::string describe(const std::vector<CaptureResult>& results, const CaptureNames& names) {
  std::string text = "Median error of reflectance by wavelength.";
  for (const CaptureResult& result : results) {
    text += " " + nameOf(result, names) + ", " + schemeOf(result, names) + ": median RMSE " +
            fixedNumber(result.figures[0][0].median, 4) + " over 400-700 nm.";
  }
  return text;
}

}  // namespace

Drawing capturePlot(const std::vector<CaptureResult>& results,
                    const std::vector<MeasuredSpectra>& sets, const CaptureNames& names,
                    const std::string& photographs) {
  Page page;
  page.heading = "Measured spectra, photographed and estimated";
  page.description = describe(results, names);
  page.introduction = {"Half of the people have a smaller error, half a larger one. " +
                       photographs + "."};
  std::vector<PanelKey> keys;
  const Axis errors = errorAxis(results);
  for (const CaptureResult& result : results) {
    const PanelKey key = keyOf(result);
    auto at = std::find(keys.begin(), keys.end(), key);
    const std::vector<double>& wavelengths = sets[result.set].wavelengthsNm;
    if (at == keys.end()) {
      Panel panel;
      panel.title = titleOf(result, names);
      panel.x = axisOf(wavelengths);
      panel.y = errors;
      panel.shades = {{kFittedRange.fromNm, kFittedRange.toNm, printTheme().shade, {}}};
      PanelRow row;
      row.height = kCapturePanelHeight;
      row.panels = {panel};
      page.rows.push_back(row);
      keys.push_back(key);
      at = keys.end() - 1;
    }
    Panel& panel = page.rows[static_cast<std::size_t>(at - keys.begin())].panels.front();
    panel.curves.push_back({wavelengths, result.medianErrors, strokeOf(result), {}});
    panel.legend.push_back({legendOf(result, names), strokeOf(result), {}});
  }
  Axis& lowest = page.rows.back().panels.front().x;
  lowest.title = "wavelength";
  lowest.unit = "nm";
  return layOut(page);
}

}  // namespace cutis
