#include <algorithm>
#include <vector>

#include "src/cli/commands/rig/rig_identify.h"
#include "src/cli/plot_style.h"
#include "src/report/picture_file.h"
#include "src/report/scale.h"

namespace cutis {
namespace {

using namespace plot_style;

constexpr double kWidth = 860.0;
constexpr double kMargin = 24.0;
constexpr double kNameRoom = 236.0;
constexpr double kHeadRoom = 74.0;
constexpr double kRow = 24.0;
constexpr double kFootRoom = 46.0;

void drawRow(Drawing& drawing, double y, const MeasurementFigures& row) {
  drawing.text({kMargin, y + 4.0}, shortened(row.name, 12.0, kNameRoom - kMargin), kLabel,
               Anchor::start);
  const double panel = (kWidth - kMargin - kNameRoom) / kParameterCount;
  for (std::size_t k = 0; k < row.result.left.size(); ++k) {
    const double begin = kNameRoom + panel * static_cast<double>(k) + 8.0;
    const Scale scale = {0.0, 1.0, begin, begin + panel - 24.0, false};
    const Spread& spread = row.result.left[k];
    drawing.line({scale.begin, y}, {scale.end, y}, kGrid);
    drawing.line({scale.at(spread.low), y}, {scale.at(spread.high), y}, {kRefined, 3.0});
    drawing.disc({scale.at(spread.median), y}, 4.5, kRefined, {kGround, 1.2});
  }
}

void drawHead(Drawing& drawing, const RigFigures& figures) {
  drawing.text(
      {kMargin, 26.0},
      "What rig " + figures.rig + " leaves open of what was known, profile " + figures.profile,
      kHeading, Anchor::start);
  const double panel = (kWidth - kMargin - kNameRoom) / kParameterCount;
  for (const Parameter parameter : kParameters) {
    const double middle = kNameRoom + panel * (static_cast<double>(parameter) + 0.5) - 4.0;
    drawing.text({middle, 56.0}, parameterSymbol(parameter), kSubheading, Anchor::middle);
  }
}

void drawFoot(Drawing& drawing, double y) {
  const double panel = (kWidth - kMargin - kNameRoom) / kParameterCount;
  for (int k = 0; k < kParameterCount; ++k) {
    const double begin = kNameRoom + panel * k + 8.0;
    drawing.text({begin, y}, "known", kNote, Anchor::start);
    drawing.text({begin + panel - 24.0, y}, "guessed", kNote, Anchor::end);
  }
  drawing.text({kMargin, y + 20.0},
               "Posterior over prior deviation: median of people drawn from the prior, and 5 to 95 "
               "of 100 of them.",
               kNote, Anchor::start);
}

}  // namespace

Status writeRigPlot(const std::string& path, const RigFigures& figures) {
  std::vector<MeasurementFigures> rows = figures.channels;
  for (MeasurementFigures noise : figures.noises) {
    noise.name = "all, noise " + noise.name;
    rows.push_back(noise);
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(3, figures.lights.size()); ++i) {
    rows.push_back(figures.lights[i]);
    rows.back().name = "and " + rows.back().name;
  }
  const double bottom = kHeadRoom + kRow * static_cast<double>(rows.size());
  Drawing drawing(kWidth, bottom + kFootRoom, "Identifiability of rig " + figures.rig,
                  "For each set of channels and each parameter of skin, the share of the prior's "
                  "deviation that a measurement leaves open.");
  drawing.rectangle({0.0, 0.0, kWidth, bottom + kFootRoom}, kGround, kNoStroke);
  drawHead(drawing, figures);
  double y = kHeadRoom;
  for (const MeasurementFigures& row : rows) {
    drawRow(drawing, y, row);
    y += kRow;
  }
  drawFoot(drawing, bottom);
  return writeDrawing(path, drawing);
}

}  // namespace cutis
