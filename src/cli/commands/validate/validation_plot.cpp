#include "src/cli/commands/validate/validation_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.h"
#include "src/report/plot/page.h"

namespace cutis {
namespace {

constexpr double kPanelHeight = 150.0;
constexpr int kSteps = 5;
constexpr double kTickNm = 100.0, kFineTickNm = 20.0;  // by how much is measured
constexpr double kManyNm = 450.0;
constexpr double kLeastScale = 1e-4;  // where there is next to no residual
constexpr std::uint8_t kSpreadAlpha = 70;

constexpr std::array<const char*, kToneThirds> kToneNames = {"Dark", "Middle", "Light"};

std::string signedWords(double value, double step) {
  return (value > 0.5 * step ? "+" : "") + tickWords(value, step);
}

// The same for all panels: from minus to plus the largest.
Axis residualAxis(const ValidationFigures& figures) {
  double most = kLeastScale;
  for (const ToneResiduals& tone : figures.tones) {
    for (std::size_t w = 0; w < tone.mean.size(); ++w)
      most = std::max(most, std::abs(tone.mean[w]) + tone.deviation[w]);
  }
  const double end = niceCeiling(most, kSteps);
  Axis axis = linearAxis(-end, end, 2 * kSteps, signedWords);
  axis.title = "residual";
  return axis;
}

Axis wavelengthAxis(const std::vector<double>& wavelengthsNm) {
  const double from = wavelengthsNm.front(), to = wavelengthsNm.back();
  const double step = to - from < kManyNm ? kFineTickNm : kTickNm;
  return linearAxis(from, to, static_cast<int>(std::ceil((to - from) / step)));
}

std::string titleOf(const ToneResiduals& tone, const char* name) {
  const std::string words = std::string(name) + " third: ";
  if (tone.spectra == 0) return words + "no spectra";
  return words + std::to_string(tone.spectra) + (tone.spectra == 1 ? " spectrum" : " spectra") +
         ", mean reflectance 400–700 nm " + fixedNumber(tone.darkest, 3) + " to " +
         fixedNumber(tone.lightest, 3);
}

Panel panelOf(const ToneResiduals& tone, const char* name, const Axis& residuals,
              const std::vector<double>& wavelengthsNm) {
  const PlotTheme& theme = printTheme();
  Panel panel;
  panel.title = titleOf(tone, name);
  panel.x = wavelengthAxis(wavelengthsNm);
  panel.y = residuals;
  panel.shades = {{kFittedRange.fromNm, kFittedRange.toNm, theme.shade, {}}};
  if (tone.spectra == 0) return panel;
  Ribbon ribbon = {wavelengthsNm, {}, {}, theme.series.orange.faded(kSpreadAlpha)};
  for (std::size_t w = 0; w < tone.mean.size(); ++w) {
    ribbon.low.push_back(tone.mean[w] - tone.deviation[w]);
    ribbon.high.push_back(tone.mean[w] + tone.deviation[w]);
  }
  panel.ribbons = {ribbon};
  panel.curves = {{wavelengthsNm, tone.mean, {theme.series.orange, 1.8}, {}}};
  return panel;
}

std::string descriptionOf(const ValidationFigures& figures) {
  std::string text = "Modelled minus measured reflectance by wavelength.";
  for (std::size_t t = 0; t < figures.tones.size(); ++t) {
    const std::vector<double>& mean = figures.tones[t].mean;
    if (mean.empty()) continue;
    const auto [least, most] = std::minmax_element(mean.begin(), mean.end());
    text += std::string(" ") + kToneNames[t] + " third: mean from " + fixedNumber(*least, 4) +
            " to " + fixedNumber(*most, 4) + ".";
  }
  return text;
}

}  // namespace

Drawing validationPlot(const ValidationFigures& figures, const std::vector<double>& wavelengthsNm,
                       const std::string& profile, const std::string& data,
                       const std::string& measurement) {
  Page page;
  page.heading = "Residual spectra: " + profile + " on " + data;
  page.description = descriptionOf(figures);
  page.introduction = {
      "Model minus measurement: above 0 the model is too bright. Line: mean; area: ± one standard "
      "deviation between spectra.",
      "Fitted to 400–700 nm alone (grey ground), predicted beyond; " + measurement + "."};
  const Axis residuals = residualAxis(figures);
  for (std::size_t t = 0; t < figures.tones.size(); ++t) {
    PanelRow row;
    row.height = kPanelHeight;
    row.panels = {panelOf(figures.tones[t], kToneNames[t], residuals, wavelengthsNm)};
    page.rows.push_back(row);
  }
  Axis& lowest = page.rows.back().panels.front().x;
  lowest.title = "wavelength";
  lowest.unit = "nm";
  return layOut(page);
}

}  // namespace cutis
