#include "src/cli/commands/train/train_plot.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "src/report/plot/page.h"

namespace cutis {
namespace {

constexpr double kCurvesHeight = 220.0, kSpectraHeight = 190.0, kComponentHeight = 72.0;
constexpr int kMostComponents = 30;  // of the panel of truncation
constexpr int kPaperComponents = 10;
constexpr int kShownAcross = 6;  // the mean and ten components, in two rows
constexpr int kSteps = 5, kEpochSteps = 5, kWavelengthSteps = 7, kComponentSteps = 6;
constexpr double kLeastError = 1e-14;
constexpr double kHeadroom = 1.08;
constexpr char kTenName[] = "by 10";
constexpr double kDot = 2.4, kDisc = 5.0;

const SeriesColors& colors() {
  return printTheme().series;
}
Stroke oursStroke() {
  return {colors().orange, 1.8};
}
Stroke tenStroke() {
  return {colors().blue, 1.8, 6.0, 4.0};
}
Stroke truthStroke() {
  return {printTheme().frame, 5.0};
}

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

struct Training {
  const std::vector<TrainingEpoch>& curve;
  const char* name;
  Color color;
};

void addTraining(Panel& panel, const Training& training) {
  std::vector<double> epochs(training.curve.size());
  std::iota(epochs.begin(), epochs.end(), 1.0);
  const Stroke learned = {training.color, 1.4, 2.0, 3.0}, heldOut = {training.color, 1.8};
  panel.curves.push_back(
      {epochs, errorsOf(training.curve, &TrainingEpoch::trainedError), learned, {}});
  panel.curves.push_back(
      {epochs, errorsOf(training.curve, &TrainingEpoch::heldOutError), heldOut, {}});
  panel.legend.push_back(
      {std::string(training.name) + ", held out: " + shortScientific(lastHeldOut(training.curve)),
       heldOut,
       {}});
  panel.legend.push_back({"while learning", learned, {}});
}

Panel lossPanel(const TrainedNetworks& trained) {
  Panel panel;
  panel.title = "Error while training";
  addTraining(panel, {trained.spectraCurve, "SpectraNN", colors().orange});
  addTraining(panel, {trained.chromophoreCurve, "ChromNN", colors().blue});
  double least = 1.0, most = kLeastError;
  std::size_t epochs = 2;
  for (const Curve& curve : panel.curves) {
    const auto [low, high] = std::minmax_element(curve.y.begin(), curve.y.end());
    least = std::min(least, *low);
    most = std::max(most, *high);
    epochs = std::max(epochs, curve.y.size());
  }
  panel.x =
      linearAxis(0.0, static_cast<double>(epochs), std::min(kEpochSteps, static_cast<int>(epochs)));
  panel.x.title = "epoch";
  panel.y = decadeAxis(least, most);
  return panel;
}

double truncationError(const TrainedNetworks& trained, int count) {
  return std::max(trained.basis.truncationError(count), kLeastError);
}

PlotPoint markedComponents(const TrainedNetworks& trained, int count, const char* who,
                           Color color) {
  const double error = truncationError(trained, count);
  PlotPoint point;
  point.x = std::min(count, kMostComponents);
  point.y = error;
  point.marker = {color, kDisc};
  point.label = who + std::to_string(count) + ": " + shortScientific(error);
  return point;
}

Panel truncationPanel(const TrainedNetworks& trained) {
  const double own = lastHeldOut(trained.spectraCurve);
  const Color ink = printTheme().ink;
  Panel panel;
  panel.title = "Error that principal components leave";
  Curve curve;
  curve.stroke = {ink, 1.6};
  curve.marker = Marker{ink, kDot};
  for (int count = 0; count <= kMostComponents; ++count) {
    curve.x.push_back(count);
    curve.y.push_back(truncationError(trained, count));
  }
  panel.x = linearAxis(0.0, kMostComponents, kComponentSteps);
  panel.x.title = "number of components";
  panel.y = decadeAxis(std::min(curve.y.back(), own), std::max(curve.y.front(), own));
  panel.levels = {
      {own, {colors().green, 1.6, 7.0, 4.0}, "SpectraNN itself: " + shortScientific(own)}};
  panel.curves = {curve};
  panel.points = {markedComponents(trained, kPaperComponents, "paper's ", colors().blue)};
  if (trained.components() != kPaperComponents) {
    panel.points.push_back(
        markedComponents(trained, trained.components(), "used, ", colors().orange));
  }
  return panel;
}

// As tall as its field; the sign of a component means nothing.
Panel componentPanel(const Spectrum& values, const std::string& name, Color color) {
  const double most = kHeadroom * values.abs().maxCoeff();
  Panel panel;
  panel.title = name;
  panel.isSmall = true;
  panel.x.from = kFirstWavelengthNm;
  panel.x.to = kLastWavelengthNm;
  panel.x.ticks = {{400.0, {}, {}, false}, {700.0, {}, {}, false}};
  panel.y.from = values.minCoeff() < 0.0 ? -most : 0.0;
  panel.y.to = most;
  panel.y.ticks = {{0.0, {}, {}, false}};
  panel.curves = {{wavelengths(), valuesOf(values), {color, 1.5}, {}}};
  return panel;
}

void addComponentRows(Page& page, const TrainedNetworks& trained) {
  const SpectraBasis& basis = trained.basis;
  std::vector<Panel> panels = {componentPanel(
      basis.mean, "mean, at most " + fixedNumber(basis.mean.maxCoeff(), 2), printTheme().ink)};
  for (int k = 0; k < kPaperComponents; ++k) {
    const double share = 100.0 * basis.variances[k] / basis.variances.sum();
    panels.push_back(componentPanel(basis.components.col(k).array(),
                                    std::to_string(k + 1) + ": " + formatNumber(share, 3) + " %",
                                    colors().orange));
  }
  PanelRow row;
  row.title = "Mean and first ten components";
  row.note =
      "300–1000 nm, lines at 400 and 700 nm; each as tall as its field, 0 where the line across "
      "is; with its share of the variance.";
  for (std::size_t first = 0; first < panels.size(); first += kShownAcross) {
    const std::size_t end = std::min(first + kShownAcross, panels.size());
    row.panels.assign(panels.begin() + static_cast<std::ptrdiff_t>(first),
                      panels.begin() + static_cast<std::ptrdiff_t>(end));
    row.columns = kShownAcross;
    row.height = kComponentHeight;
    page.rows.push_back(row);
    row = {};
  }
}

Spectrum rebuilt(const SpectraBasis& basis, const Spectrum& spectrum, int count) {
  const Eigen::MatrixXd components = basis.components.leftCols(count);
  return basis.mean +
         (components * (components.transpose() * (spectrum - basis.mean).matrix())).array();
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

Curve spectrumCurve(const Spectrum& spectrum, const Stroke& stroke) {
  return {wavelengths(), valuesOf(spectrum), stroke, {}};
}

Axis wavelengthAxis() {
  Axis axis = linearAxis(kFirstWavelengthNm, kLastWavelengthNm, kWavelengthSteps);
  axis.title = "wavelength";
  axis.unit = "nm";
  return axis;
}

Panel wholePanel(const Rebuilt& example, double most) {
  Panel panel;
  panel.title = "A spectrum and what components make of it";
  panel.x = wavelengthAxis();
  panel.y = linearAxis(0.0, most, kSteps);
  panel.curves = {spectrumCurve(example.truth, truthStroke()),
                  spectrumCurve(example.used, oursStroke()),
                  spectrumCurve(example.ten, tenStroke())};
  panel.legend = {{"the skin model", truthStroke(), {}}, {example.usedName, oursStroke(), {}}};
  if (example.usedName != kTenName) panel.legend.push_back({kTenName, tenStroke(), {}});
  return panel;
}

Panel differencePanel(const Rebuilt& example, double whole) {
  const Spectrum ten = example.ten - example.truth, used = example.used - example.truth;
  const double most = std::max({ten.abs().maxCoeff(), used.abs().maxCoeff(), kLeastError});
  const double end = niceCeiling(most, kSteps);
  Panel panel;
  panel.title = "The difference, " + fixedNumber(whole / (2.0 * end), 0) + " times as tall";
  panel.x = wavelengthAxis();
  panel.y = linearAxis(-end, end, 2 * kSteps);
  panel.curves = {spectrumCurve(ten, tenStroke()), spectrumCurve(used, oursStroke())};
  return panel;
}

PanelRow spectrumRow(const SkinModel& model, const TrainedNetworks& trained) {
  const Rebuilt example = rebuiltExample(model, trained);
  const double most = niceCeiling(example.truth.maxCoeff(), kSteps);
  PanelRow row;
  row.height = kSpectraHeight;
  row.panels = {wholePanel(example, most), differencePanel(example, most)};
  return row;
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
  Page page;
  page.heading = "Networks of rig " + trained.file.rig + ", profile " + trained.file.profile;
  page.description = descriptionOf(trained);
  page.introduction = {
      "Errors are mean squared errors of reflectance, 300–1000 nm. ChromNN's holds what its "
      "channels leave open."};
  PanelRow errors;
  errors.height = kCurvesHeight;
  errors.panels = {lossPanel(trained), truncationPanel(trained)};
  page.rows = {errors};
  addComponentRows(page, trained);
  page.rows.push_back(spectrumRow(model, trained));
  return layOut(page);
}

}  // namespace cutis
