#include "src/cli/commands/validate/validation_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.h"
#include "src/cli/plot_style.h"
#include "src/report/scale.h"

namespace cutis {
namespace {

using namespace plot_style;

constexpr double kWidth = 920.0, kHeight = 730.0;
constexpr double kLeft = 84.0, kRight = 886.0, kMargin = 24.0;
constexpr double kFirstTop = 112.0, kPanelHeight = 150.0, kPanelStep = 194.0;
constexpr char kFittedGround[] = "#f1f4f7";
constexpr char kSpread[] = "#f3cdb8";
constexpr double kTickNm = 100.0, kFineTickNm = 20.0;  // by how much is measured
constexpr double kManyNm = 450.0;
constexpr double kLeastScale = 1e-4;  // where there is next to no residual

constexpr std::array<const char*, kToneThirds> kToneNames = {"Dark", "Middle", "Light"};

// Wavelengths that are shown, and the scale of residuals.
struct Axes {
  const std::vector<double>& wavelengthsNm;
  std::vector<double> ticks;  // from 0
};

Axes axesOf(const ValidationFigures& figures, const std::vector<double>& wavelengthsNm) {
  double most = kLeastScale;
  for (const ToneResiduals& tone : figures.tones) {
    for (std::size_t w = 0; w < tone.mean.size(); ++w)
      most = std::max(most, std::abs(tone.mean[w]) + tone.deviation[w]);
  }
  return {wavelengthsNm, linearTicks(most)};
}

Box panelBox(std::size_t tone) {
  const double top = kFirstTop + kPanelStep * static_cast<double>(tone);
  return {kLeft, top, kRight, top + kPanelHeight};
}

Scale across(const Axes& axes) {
  return {axes.wavelengthsNm.front(), axes.wavelengthsNm.back(), kLeft, kRight};
}

Scale upwards(const Axes& axes, const Box& box) {
  return {-axes.ticks.back(), axes.ticks.back(), box.bottom, box.top};
}

void drawGround(Drawing& drawing, const Axes& axes, const Box& box) {
  const Scale x = across(axes), y = upwards(axes, box);
  drawing.rectangle({x.at(kFittedRange.fromNm), box.top, x.at(kFittedRange.toNm), box.bottom},
                    kFittedGround, kNoStroke);
  const double step =
      axes.wavelengthsNm.back() - axes.wavelengthsNm.front() < kManyNm ? kFineTickNm : kTickNm;
  for (double nm = step * std::ceil(axes.wavelengthsNm.front() / step);
       nm <= axes.wavelengthsNm.back(); nm += step) {
    drawing.line({x.at(nm), box.top}, {x.at(nm), box.bottom}, kGrid);
    drawing.text({x.at(nm), box.bottom + 15.0}, formatNumber(nm), kTick, Anchor::middle);
  }
  for (const double tick : axes.ticks) {
    for (const double value : {-tick, tick}) {
      drawing.line({box.left, y.at(value)}, {box.right, y.at(value)},
                   value == 0.0 ? kFrame : kGrid);
      const std::string words = (value > 0.0   ? "+"
                                 : value < 0.0 ? "−"
                                               : "") +
                                formatNumber(std::abs(value), 3);
      drawing.text({box.left - 8.0, y.at(value) + 4.0}, words, kTick, Anchor::end);
      if (tick == 0.0) break;
    }
  }
}

void drawResiduals(Drawing& drawing, const Axes& axes, const Box& box, const ToneResiduals& tone) {
  const Scale x = across(axes), y = upwards(axes, box);
  std::vector<Point> mean, outline;
  const std::size_t count = tone.mean.size();
  for (std::size_t w = 0; w < count; ++w) {
    const double at = x.at(axes.wavelengthsNm[w]);
    mean.push_back({at, y.at(tone.mean[w])});
    outline.push_back({at, y.at(tone.mean[w] + tone.deviation[w])});
  }
  for (std::size_t w = count; w-- > 0;) {
    outline.push_back({x.at(axes.wavelengthsNm[w]), y.at(tone.mean[w] - tone.deviation[w])});
  }
  drawing.area(outline, kSpread);
  drawing.line({box.left, y.at(0.0)}, {box.right, y.at(0.0)}, kFrame);
  drawing.polyline(mean, {kRefined, 1.8, ""});
}

void drawPanel(Drawing& drawing, const Axes& axes, const ValidationFigures& figures,
               std::size_t index) {
  const Box box = panelBox(index);
  const ToneResiduals& tone = figures.tones[index];
  drawGround(drawing, axes, box);
  std::string words = std::string(kToneNames[index]) + " third: ";
  if (tone.spectra == 0) {
    words += "no spectra";
  } else {
    words += std::to_string(tone.spectra) + (tone.spectra == 1 ? " spectrum" : " spectra") +
             ", mean reflectance 400–700 nm " + fixedNumber(tone.darkest, 3) + " to " +
             fixedNumber(tone.lightest, 3);
    drawResiduals(drawing, axes, box, tone);
  }
  drawing.rectangle(box, "none", kFrame);
  drawing.text({box.left, box.top - 7.0}, words, kLabel, Anchor::start);
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
  const std::string title = "Residual spectra: " + profile + " on " + data;
  const double room = kRight - kMargin;
  Drawing drawing(kWidth, kHeight, title, descriptionOf(figures));
  drawing.rectangle({0.5, 0.5, kWidth - 0.5, kHeight - 0.5}, kGround, {kGridColor, 1.0, ""}, 6.0);
  drawing.text({kMargin, 32.0}, shortened(title, kHeading.size, room / 1.15), kHeading,
               Anchor::start);
  drawing.text({kMargin, 54.0},
               "Model minus measurement: above 0 the model is too bright. Line: mean; area: ± one "
               "standard deviation between spectra.",
               kLabel, Anchor::start);
  drawing.text(
      {kMargin, 72.0},
      shortened("Fitted to 400–700 nm alone (grey ground), predicted beyond; " + measurement + ".",
                kLabel.size, room),
      kLabel, Anchor::start);
  const Axes axes = axesOf(figures, wavelengthsNm);
  for (std::size_t t = 0; t < figures.tones.size(); ++t)
    drawPanel(drawing, axes, figures, t);
  drawing.text({0.5 * (kLeft + kRight), kHeight - 30.0}, "wavelength, nm", kLabel, Anchor::middle);
  drawing.textUpwards({24.0, kFirstTop + kPanelStep + 0.5 * kPanelHeight},
                      "residual of the reflectance", kLabel);
  return drawing;
}

}  // namespace cutis
