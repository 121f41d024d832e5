#include <algorithm>
#include <vector>

#include "src/cli/commands/rig/rig_identify.h"
#include "src/report/picture_file.h"
#include "src/report/plot/page.h"

namespace cutis {
namespace {

constexpr std::size_t kMostLights = 3;
constexpr double kRowHeight = 22.0;
constexpr double kBarWidth = 3.0;
constexpr double kDisc = 4.5;

// The sets of channels from top to bottom.
std::vector<MeasurementFigures> rowsOf(const RigFigures& figures) {
  std::vector<MeasurementFigures> rows = figures.channels;
  for (MeasurementFigures noise : figures.noises) {
    noise.name = "all, noise " + noise.name;
    rows.push_back(noise);
  }
  for (std::size_t i = 0; i < std::min(kMostLights, figures.lights.size()); ++i) {
    rows.push_back(figures.lights[i]);
    rows.back().name = "and " + rows.back().name;
  }
  return rows;
}

// Below 0, so that no row is taken for the zero of an axis.
double placeOf(std::size_t row) {
  return -1.0 - static_cast<double>(row);
}

// Names stand beside the first panel alone.
Axis rowAxis(const std::vector<MeasurementFigures>& rows, bool named) {
  Axis axis;
  axis.from = -static_cast<double>(rows.size()) - 0.5;
  axis.to = -0.5;
  for (std::size_t i = rows.size(); i-- > 0;)
    axis.ticks.push_back({placeOf(i), named ? rows[i].name : "", {}, false});
  return axis;
}

Panel panelOf(const std::vector<MeasurementFigures>& rows, Parameter parameter) {
  const auto k = static_cast<std::size_t>(parameter);
  Panel panel;
  panel.title = parameterSymbol(parameter);
  panel.x.ticks = {{0.0, "known", {}, false}, {1.0, "guessed", {}, false}};
  panel.x.hasGrid = false;
  panel.y = rowAxis(rows, k == 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Spread& spread = rows[i].result.left[k];
    PlotPoint point;
    point.x = spread.median;
    point.y = placeOf(i);
    point.across = {spread.low, spread.high};
    point.barWidth = kBarWidth;
    point.marker = {printTheme().series.orange, kDisc};
    panel.points.push_back(point);
  }
  return panel;
}

}  // namespace

Status writeRigPlot(const std::string& path, const RigFigures& figures) {
  const auto rows = rowsOf(figures);
  Page page;
  page.heading =
      "What rig " + figures.rig + " leaves open of what was known, profile " + figures.profile;
  page.description =
      "For each set of channels and each parameter of skin, the share of the prior's deviation "
      "that a measurement leaves open.";
  PanelRow row;
  row.height = kRowHeight * static_cast<double>(rows.size());
  for (const Parameter parameter : kParameters)
    row.panels.push_back(panelOf(rows, parameter));
  page.rows = {row};
  page.notes = {
      "Posterior over prior deviation: median of people drawn from the prior, and 5 to 95 of 100 "
      "of them."};
  return writeDrawing(path, layOut(page));
}

}  // namespace cutis
