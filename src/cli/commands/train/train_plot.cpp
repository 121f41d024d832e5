#include "src/cli/commands/train/train_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "src/cli/plot_panel.h"
#include "src/cli/plot_style.h"

namespace cutis {
namespace {

using namespace plot_style;

constexpr double kWidth = 920.0, kHeight = 934.0;
constexpr double kMargin = 24.0;
constexpr Box kLoss = {78.0, 104.0, 452.0, 334.0};
constexpr Box kTruncation = {534.0, 104.0, 896.0, 334.0};
constexpr Box kComponents = {24.0, 424.0, 896.0, 614.0};
constexpr Box kSpectrum = {78.0, 678.0, 452.0, 868.0};
constexpr Box kDifference = {534.0, 678.0, 896.0, 868.0};

constexpr int kMostComponents = 30;  // of the panel of truncation
constexpr int kPaperComponents = 10;
constexpr int kShownAcross = 6;  // the mean and ten components, in two rows
constexpr double kLeastError = 1e-14;
constexpr double kDisc = 5.0;

constexpr Stroke kOurs = {kRefined, 1.8, ""};
constexpr Stroke kOursTrained = {kRefined, 1.4, "2 3"};
constexpr Stroke kSecond = {kPaper, 1.8, ""};
constexpr Stroke kSecondTrained = {kPaper, 1.4, "2 3"};
constexpr Stroke kTruth = {kFrameColor, 5.0, ""};
constexpr Stroke kTen = {kPaper, 1.8, "6 4"};
constexpr Stroke kOwn = {kBound, 1.6, "7 4"};

const std::vector<double>& wavelengths() {
  static const std::vector<double> values = [] {
    std::vector<double> all;
    for (int i = 0; i < kSampleCount; ++i)
      all.push_back(wavelengthNm(i));
    return all;
  }();
  return values;
}

std::vector<double> valuesOf(const Spectrum& spectrum) {
  return {spectrum.begin(), spectrum.end()};
}

std::vector<double> errorsOf(const std::vector<TrainingEpoch>& curve,
                             double TrainingEpoch::*error) {
  std::vector<double> values;
  for (const TrainingEpoch& epoch : curve)
    values.push_back(std::max(epoch.*error, kLeastError));
  return values;
}

double lastHeldOut(const std::vector<TrainingEpoch>& curve) {
  double least = curve.front().heldOutError;
  for (const TrainingEpoch& epoch : curve)
    least = std::min(least, epoch.heldOutError);
  return std::max(least, kLeastError);
}

void drawLosses(Drawing& drawing, const TrainedNetworks& trained) {
  struct Series {
    const std::vector<TrainingEpoch>& curve;
    Stroke heldOut, learned;
    const char* name;
  };
  const std::array<Series, 2> series = {
      {{trained.spectraCurve, kOurs, kOursTrained, "SpectraNN"},
       {trained.chromophoreCurve, kSecond, kSecondTrained, "ChromNN"}}};
  double least = 1.0, most = kLeastError;
  std::size_t epochs = 2;
  for (const Series& one : series) {
    for (const TrainingEpoch& epoch : one.curve) {
      const auto [low, high] = std::minmax(epoch.trainedError, epoch.heldOutError);
      least = std::min(least, std::max(low, kLeastError));
      most = std::max(most, high);
    }
    epochs = std::max(epochs, one.curve.size());
  }
  // A decade of room for the names.
  const PlotPanel panel = decadePanel(kLoss, 0.0, static_cast<double>(epochs), least, 10.0 * most);
  drawDecades(drawing, panel);
  drawAcross(drawing, panel, linearTicks(static_cast<double>(epochs)));
  std::vector<double> across(epochs);
  std::iota(across.begin(), across.end(), 1.0);
  double key = kLoss.top + 18.0;
  for (const Series& one : series) {
    drawCurve(drawing, panel, across, errorsOf(one.curve, &TrainingEpoch::trainedError),
              one.learned);
    drawCurve(drawing, panel, across, errorsOf(one.curve, &TrainingEpoch::heldOutError),
              one.heldOut);
    const double half = kLoss.left + 12.0;
    drawKey(drawing, {half, key}, one.heldOut,
            std::string(one.name) + ", held out: " + shortScientific(lastHeldOut(one.curve)));
    drawKey(drawing, {half + 210.0, key}, one.learned, "while learning");
    key += 17.0;
  }
  drawFrame(drawing, panel, "Error while training", "epoch");
}

// Above the curve on its right, or below it on its left.
void drawMarked(Drawing& drawing, const PlotPanel& panel, int count, double error,
                const std::string& words, const char* color, bool above) {
  const Point at = panel.at(count, error);
  drawing.disc(at, kDisc + 2.0, kGround, kNoStroke);
  drawing.disc(at, kDisc, color, kNoStroke);
  TextStyle style = kLabel;
  style.color = color;
  drawing.text(above ? Point{at.x + 9.0, at.y - 12.0} : Point{at.x - 9.0, at.y + 16.0}, words,
               style, above ? Anchor::start : Anchor::end);
}

void drawTruncation(Drawing& drawing, const TrainedNetworks& trained) {
  std::vector<double> counts, errors;
  for (int count = 0; count <= kMostComponents; ++count) {
    counts.push_back(count);
    errors.push_back(std::max(trained.basis.truncationError(count), kLeastError));
  }
  const double own = lastHeldOut(trained.spectraCurve);
  const PlotPanel panel =
      decadePanel(kTruncation, 0.0, kMostComponents, std::min(errors.back(), own), errors.front());
  drawDecades(drawing, panel);
  drawAcross(drawing, panel, {0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0});
  drawing.line(panel.at(0.0, own), panel.at(kMostComponents, own), kOwn);
  TextStyle style = kLabel;
  style.color = kBound;
  drawing.text({kTruncation.right - 8.0, panel.y.at(own) - 7.0},
               "SpectraNN itself: " + shortScientific(own), style, Anchor::end);
  drawCurve(drawing, panel, counts, errors, {kInk, 1.6, ""});
  for (std::size_t i = 0; i < counts.size(); ++i)
    drawing.disc(panel.at(counts[i], errors[i]), 2.4, kInk, kNoStroke);
  const auto mark = [&](int count, const char* who, const char* color, bool above) {
    const double error = std::max(trained.basis.truncationError(count), kLeastError);
    drawMarked(drawing, panel, std::min(count, kMostComponents), error,
               who + std::to_string(count) + ": " + shortScientific(error), color, above);
  };
  mark(kPaperComponents, "paper's ", kPaper, true);
  if (trained.components() != kPaperComponents)
    mark(trained.components(), "used, ", kRefined, false);
  drawFrame(drawing, panel, "Error that principal components leave", "number of components");
}

// In a small field of its own, as tall as it fits; the sign of a component means nothing.
void drawComponent(Drawing& drawing, int place, const Spectrum& values, const std::string& name) {
  const double wide = (kComponents.right - kComponents.left) / kShownAcross;
  const double tall = 0.5 * (kComponents.bottom - kComponents.top);
  const double left = kComponents.left + wide * (place % kShownAcross);
  const double top = kComponents.top + tall * (place / kShownAcross);
  const Box box = {left + 3.0, top + 18.0, left + wide - 5.0, top + tall - 4.0};
  const double most = 1.08 * values.abs().maxCoeff();
  const PlotPanel panel = plotPanel(box, kFirstWavelengthNm, kLastWavelengthNm,
                                    values.minCoeff() < 0.0 ? -most : 0.0, most);
  for (const double nm : {400.0, 700.0})
    drawing.line({panel.x.at(nm), box.top}, {panel.x.at(nm), box.bottom}, kGrid);
  drawing.line({box.left, panel.y.at(0.0)}, {box.right, panel.y.at(0.0)}, kFrame);
  drawCurve(drawing, panel, wavelengths(), valuesOf(values), {place == 0 ? kInk : kRefined, 1.5});
  drawing.rectangle(box, "none", kFrame);
  drawing.text({box.left, box.top - 5.0}, name, kTick, Anchor::start);
}

void drawComponents(Drawing& drawing, const TrainedNetworks& trained) {
  const SpectraBasis& basis = trained.basis;
  drawing.text({kMargin, kComponents.top - 26.0}, "Mean and first ten components", kSubheading,
               Anchor::start);
  drawing.text({kMargin, kComponents.top - 9.0},
               "300–1000 nm, lines at 400 and 700 nm; each as tall as its field, 0 where the line "
               "across is; with its share of the variance.",
               kNote, Anchor::start);
  drawComponent(drawing, 0, basis.mean, "mean, at most " + fixedNumber(basis.mean.maxCoeff(), 2));
  for (int k = 0; k < kPaperComponents; ++k) {
    const double share = 100.0 * basis.variances[k] / basis.variances.sum();
    drawComponent(drawing, k + 1, basis.components.col(k).array(),
                  std::to_string(k + 1) + ": " + formatNumber(share, 3) + " %");
  }
}

Spectrum rebuilt(const SpectraBasis& basis, const Spectrum& spectrum, int count) {
  const Eigen::MatrixXd components = basis.components.leftCols(count);
  return basis.mean +
         (components * (components.transpose() * (spectrum - basis.mean).matrix())).array();
}

void drawWavelengths(Drawing& drawing, const PlotPanel& panel) {
  drawAcross(drawing, panel, {300.0, 400.0, 500.0, 600.0, 700.0, 800.0, 900.0, 1000.0});
}

// A spectrum of the skin model and what components make of it: 10, and as many as are used.
struct Rebuilt {
  Spectrum truth, ten, used;
  std::string usedName;
};

Rebuilt rebuiltExample(const SkinModel& model, const TrainedNetworks& trained) {
  // Light skin with some of everything (the second of MODEL's check values).
  const Spectrum truth = model.reflectance({0.02, 0.5, 0.02, 0.01, 0.001});
  return {truth, rebuilt(trained.basis, truth, kPaperComponents),
          rebuilt(trained.basis, truth, trained.components()),
          "by " + std::to_string(trained.components())};
}

void drawWhole(Drawing& drawing, const Rebuilt& example, double most) {
  const PlotPanel panel = plotPanel(kSpectrum, kFirstWavelengthNm, kLastWavelengthNm, 0.0, most);
  drawWavelengths(drawing, panel);
  drawUpwards(drawing, panel, linearTicks(most));
  drawCurve(drawing, panel, wavelengths(), valuesOf(example.truth), kTruth);
  drawCurve(drawing, panel, wavelengths(), valuesOf(example.used), kOurs);
  drawCurve(drawing, panel, wavelengths(), valuesOf(example.ten), kTen);
  drawFrame(drawing, panel, "A spectrum and what components make of it", "wavelength, nm");
  const Point key = {kSpectrum.right - 130.0, kSpectrum.bottom - 50.0};
  drawKey(drawing, key, kTruth, "the skin model");
  drawKey(drawing, {key.x, key.y + 18.0}, kOurs, example.usedName);
  if (example.usedName != "by 10") drawKey(drawing, {key.x, key.y + 36.0}, kTen, "by 10");
}

void drawDifference(Drawing& drawing, const Rebuilt& example, double whole) {
  const Spectrum ten = example.ten - example.truth, used = example.used - example.truth;
  const auto ticks =
      linearTicks(std::max({ten.abs().maxCoeff(), used.abs().maxCoeff(), kLeastError}));
  const PlotPanel panel =
      plotPanel(kDifference, kFirstWavelengthNm, kLastWavelengthNm, -ticks.back(), ticks.back());
  drawWavelengths(drawing, panel);
  drawUpwards(drawing, panel, ticks);
  std::vector<double> below;
  for (auto tick = ticks.begin() + 1; tick != ticks.end(); ++tick)
    below.push_back(-*tick);
  drawUpwards(drawing, panel, below);
  drawCurve(drawing, panel, wavelengths(), valuesOf(ten), kTen);
  drawCurve(drawing, panel, wavelengths(), valuesOf(used), kOurs);
  const double magnified = whole / (2.0 * ticks.back());
  drawFrame(drawing, panel, "The difference, " + fixedNumber(magnified, 0) + " times as tall",
            "wavelength, nm");
}

void drawSpectrum(Drawing& drawing, const SkinModel& model, const TrainedNetworks& trained) {
  const Rebuilt example = rebuiltExample(model, trained);
  const double most = linearTicks(example.truth.maxCoeff()).back();
  drawWhole(drawing, example, most);
  drawDifference(drawing, example, most);
}

std::string descriptionOf(const TrainedNetworks& trained) {
  return "Training of SpectraNN and ChromNN: errors by epoch, at last " +
         shortScientific(lastHeldOut(trained.spectraCurve)) + " and " +
         shortScientific(lastHeldOut(trained.chromophoreCurve)) +
         "; the error that principal components leave, " +
         shortScientific(trained.basis.truncationError(kPaperComponents)) + " for ten and " +
         shortScientific(trained.basis.truncationError(trained.components())) + " for the " +
         std::to_string(trained.components()) +
         " used; the components by wavelength; and a spectrum rebuilt from them.";
}

}  // namespace

Drawing trainPlot(const SkinModel& model, const TrainedNetworks& trained) {
  const std::string title =
      "Networks of rig " + trained.file.rig + ", profile " + trained.file.profile;
  Drawing drawing(kWidth, kHeight, title, descriptionOf(trained));
  drawing.rectangle({0.5, 0.5, kWidth - 0.5, kHeight - 0.5}, kGround, {kGridColor, 1.0, ""}, 6.0);
  drawing.text({kMargin, 32.0}, shortened(title, kHeading.size, kWidth - 3.0 * kMargin), kHeading,
               Anchor::start);
  drawing.text(
      {kMargin, 54.0},
      "Errors are mean squared errors of reflectance, 300–1000 nm. ChromNN's holds what its "
      "channels leave open.",
      kLabel, Anchor::start);
  drawLosses(drawing, trained);
  drawTruncation(drawing, trained);
  drawComponents(drawing, trained);
  drawSpectrum(drawing, model, trained);
  return drawing;
}

}  // namespace cutis
