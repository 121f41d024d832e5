#include "src/cli/commands/rig/rig_identify.h"

#include "core/base/number_text.h"
#include "src/cli/text_table.h"

namespace cutis {
namespace {

std::string counted(const std::string& what, int channels) {
  return what + ", " + std::to_string(channels) + " channels";
}

std::string percent(double share) {
  return fixedNumber(100.0 * share, 0);
}

std::string tableOf(const std::string& heading, const std::vector<MeasurementFigures>& rows) {
  std::vector<std::string> head = {heading};
  for (const Parameter parameter : kParameters)
    head.emplace_back(parameterSymbol(parameter));
  for (const char* band : {"vis", "UV", "NIR"})
    head.emplace_back(band);
  TextTable table(head);
  for (const MeasurementFigures& row : rows) {
    std::vector<std::string> cells = {row.name};
    for (const Spread& spread : row.result.left) {
      cells.push_back(percent(spread.median) + " (" + percent(spread.low) + "–" +
                      percent(spread.high) + ")");
    }
    for (const double deviation :
         {row.result.visible, row.result.ultraviolet, row.result.nearInfrared}) {
      cells.push_back(fixedNumber(deviation, 4));
    }
    table.add(cells);
  }
  return table.text();
}

}  // namespace

RigFigures namedFigures(const RigStudy& study, const std::string& rig, const std::string& profile,
                        std::size_t people) {
  RigFigures figures = {rig, profile, people, study.noise, {}, {}, {}};
  figures.channels.push_back({counted("all", study.channels), study.all});
  if (study.paper) figures.channels.push_back({"r, g, b, sb, sg of the paper", *study.paper});
  for (const LightFigures& one : study.alone)
    figures.channels.push_back({counted(one.light + " alone", 3), one.result});
  for (const NoiseFigures& at : study.noises)
    figures.noises.push_back({percentText(at.proportional, 3), at.result});
  for (const LightFigures& more : study.added)
    figures.lights.push_back({more.light, more.result});
  return figures;
}

std::string rigTables(const RigFigures& figures) {
  std::string text =
      "rig " + figures.rig + ", profile " + figures.profile + ", " +
      std::to_string(figures.people) + " people of the prior, noise " +
      formatNumber(figures.noise.read, 3) + " and " + percentText(figures.noise.proportional, 3) +
      "\n" +
      "Parameters: what stays open of the prior's deviation, in percent: median (5–95 % of the\n"
      "people); 0 is known, 100 is guessed. Spectra: root mean square deviation of the predicted\n"
      "reflectance, 400–700, 300–400 and 700–1000 nm.\n\n";
  text += tableOf("channels", figures.channels);
  text += "\n" + tableOf("all, noise", figures.noises);
  if (figures.lights.empty()) return text;
  return text + "\n" + tableOf("one more light, best first", figures.lights);
}

}  // namespace cutis
