#include "src/cli/commands/bench/bench_table.h"

#include <cmath>

#include "core/base/number_text.h"
#include "src/bench/goals.h"
#include "src/cli/commands/bench/bench_remarks.h"
#include "src/cli/console.h"
#include "src/cli/text_table.h"

namespace cutis {
namespace {

std::string percent(double share) {
  return percentText(share, 3);
}

std::string pair(double a, double b) {
  return fixedNumber(a, 2) + "/" + fixedNumber(b, 2);
}

std::string rounded(double value) {
  return fixedNumber(value, value < 100.0 ? 1 : 0);
}

// A method measured on the subsample has a mark.
std::string labelOf(BenchMethod method) {
  return std::string(methodLabel(method)) + (isExhaustive(method) ? " *" : "");
}

std::string heading(const std::string& text) {
  return "\n" + text + "\n";
}

std::string errorTable(const std::vector<MethodFigures>& methods) {
  TextTable table({"method", "noise", "vis MSE", "/bound", "UV MSE", "NIR MSE", "dE D65", "dE A",
                   "ns/pixel", "steps"});
  std::optional<BenchMethod> last;
  for (const MethodFigures& row : methods) {
    const ErrorSummary& errors = row.errors;
    table.add({last == row.method ? "" : labelOf(row.method), percent(row.noise),
               shortScientific(errors.visibleMse),
               row.overBound ? fixedNumber(*row.overBound, 2) : "",
               shortScientific(errors.ultravioletMse), shortScientific(errors.nearInfraredMse),
               pair(errors.medianDeltaE_D65, errors.deltaE95_D65),
               pair(errors.medianDeltaE_A, errors.deltaE95_A), rounded(row.nanosecondsPerPixel),
               isRefined(row.method) ? fixedNumber(row.meanIterations, 1) : ""});
    last = row.method;
  }
  return table.text();
}

std::string boundRows(const BenchFigures& figures) {
  TextTable table({"noise", "vis", "as designed", "UV", "NIR"});
  for (const BoundFigures& row : figures.bounds) {
    table.add({percent(row.noise), shortScientific(row.bound.visible),
               row.printed ? shortScientific(*row.printed) : "",
               shortScientific(row.bound.ultraviolet), shortScientific(row.bound.nearInfrared)});
  }
  return table.text();
}

std::string publishedTable() {
  TextTable table({"paper, Titan X", "vis MSE, no noise", "2048²"});
  for (const PublishedFigures& row : kPublished) {
    table.add({row.method, shortScientific(row.visibleMse),
               row.secondsFor2048 < 60.0 ? formatNumber(row.secondsFor2048, 3) + " s"
                                         : durationText(row.secondsFor2048)});
  }
  return table.text();
}

std::string parameterErrors(const BenchFigures& figures) {
  std::vector<std::string> head = {"method"};
  for (const Parameter parameter : kParameters)
    head.emplace_back(parameterSymbol(parameter));
  TextTable table(head);
  for (const MethodFigures& row : figures.methods) {
    if (row.noise != kUsualNoise) continue;
    std::vector<std::string> cells = {labelOf(row.method)};
    for (const double rmse : row.errors.parameterRmse)
      cells.push_back(formatNumber(rmse, 3));
    table.add(cells);
  }
  return table.text();
}

std::string toneTable(const BenchFigures& figures) {
  std::vector<std::string> head = {"method"};
  for (int tone = 0; tone < kToneCount; ++tone)
    head.emplace_back(toneName(tone));
  TextTable table(head);
  bool counted = false;
  for (const MethodFigures& row : figures.methods) {
    if (row.noise != kUsualNoise) continue;
    std::vector<std::string> counts = {"pixels"}, cells = {labelOf(row.method)};
    for (const ErrorSummary& tone : row.tones) {
      counts.push_back(std::to_string(tone.pixels));
      cells.push_back(tone.pixels == 0 ? "-"
                                       : shortScientific(tone.visibleMse) + "  dE " +
                                             fixedNumber(tone.medianDeltaE_D65, 2));
    }
    if (!counted) table.add(counts);
    counted = true;
    table.add(cells);
  }
  return table.text();
}

std::string coverageRows(const BenchFigures& figures) {
  std::vector<std::string> head = {"prior, where"};
  for (const Parameter parameter : kParameters)
    head.emplace_back(parameterSymbol(parameter));
  head.emplace_back("all");
  TextTable table(head);
  const auto cell = [](const Coverage::Count& count) {
    return count.pixels == 0
               ? "-"
               : fixedNumber(100.0 * count.share(), 1) + " % of " + std::to_string(count.pixels);
  };
  const auto row = [&](const std::string& name, const auto& counts) {
    std::vector<std::string> cells = {name};
    for (const Coverage::Count& count : counts)
      cells.push_back(cell(count));
    cells.push_back(cell(pooled(counts)));
    table.add(cells);
  };
  for (const CoverageFigures& figure : figures.coverage) {
    row(figure.prior + ", measured", figure.coverage.measured);
    row(figure.prior + ", elsewhere", figure.coverage.assumed);
  }
  return table.text();
}

std::string variantTable(const std::vector<VariantFigures>& variants, const std::string& name) {
  TextTable table({name, "noise", "vis MSE", "UV MSE", "UV RMSE", "UV bound", "dE D65"});
  for (const VariantFigures& row : variants) {
    table.add({row.variant, percent(row.noise), shortScientific(row.errors.visibleMse),
               shortScientific(row.errors.ultravioletMse),
               fixedNumber(std::sqrt(row.errors.ultravioletMse), 4),
               row.bound ? shortScientific(row.bound->ultraviolet) : "",
               pair(row.errors.medianDeltaE_D65, row.errors.deltaE95_D65)});
  }
  return table.text();
}

std::string pictureTable(const std::vector<PictureFigures>& pictures) {
  TextTable table({"picture", "method", "noise", "threads", "seconds", "ns/pixel", "solved",
                   "equal", "steps", "fit memory"},
                  2);
  for (const PictureFigures& row : pictures) {
    const double pixels = static_cast<double>(row.size) * row.size;
    table.add({std::to_string(row.size) + "² " + row.content, methodLabel(row.method),
               percent(row.noise), std::to_string(row.threads),
               (row.scaled ? "~" : "") + fixedNumber(row.seconds, row.seconds < 100.0 ? 3 : 0),
               rounded(1e9 * row.seconds / pixels), row.scaled ? "" : std::to_string(row.solved),
               row.scaled ? "" : std::to_string(row.duplicate),
               row.scaled || !isRefined(row.method) ? "" : fixedNumber(row.meanIterations, 1),
               row.memoryBytes ? rounded(static_cast<double>(*row.memoryBytes) / 0x1p20) + " MB"
                               : (row.scaled ? "" : "-")});
  }
  return table.text();
}

std::string perPixel(double seconds, int size) {
  return rounded(1e9 * seconds / (static_cast<double>(size) * size));
}

std::string networkErrors(const std::vector<NetworkFigures>& networks) {
  TextTable table({"lights", "channels", "noise", "encode", "encode + decode"});
  for (const NetworkFigures& row : networks) {
    for (const NetworkFigures::AtNoise& at : row.errors) {
      const bool first = &at == &row.errors.front();
      table.add({first ? std::to_string(row.lights) : "", first ? std::to_string(row.channels) : "",
                 percent(at.noise), shortScientific(at.encodedMse), shortScientific(at.bothMse)});
    }
  }
  return table.text();
}

std::string networkCosts(const std::vector<NetworkFigures>& networks) {
  TextTable table({"lights", "channels", "SpectraNN vis", "UV", "NIR", "weights", "work/pixel",
                   "picture", "encode", "encode + decode", "ns/pixel"});
  for (const NetworkFigures& row : networks) {
    table.add({std::to_string(row.lights), std::to_string(row.channels),
               shortScientific(row.decoded.visible), shortScientific(row.decoded.ultraviolet),
               shortScientific(row.decoded.nearInfrared), std::to_string(row.weights),
               std::to_string(row.workPerPixel), std::to_string(row.size) + "²",
               fixedNumber(row.encodeSeconds, 3) + " s", fixedNumber(row.bothSeconds, 3) + " s",
               perPixel(row.bothSeconds, row.size)});
  }
  return table.text();
}

std::string usual() {
  return "at " + percent(kUsualNoise) + " noise";
}

std::string withUnit(double value, GoalUnit unit) {
  switch (unit) {
    case GoalUnit::none:
      return formatNumber(value, 3);
    case GoalUnit::meanSquare:
      return shortScientific(value);
    case GoalUnit::seconds:
      return formatNumber(value, 3) + " s";
    case GoalUnit::microseconds:
      return formatNumber(value, 3) + " µs";
    case GoalUnit::percent:
      return formatNumber(value, 4) + " %";
  }
  return {};
}

// "≤ 0.9 s", "93 to 97 %"
std::string askedText(const Goal& goal) {
  if (goal.least && goal.most)
    return formatNumber(*goal.least) + " to " + withUnit(*goal.most, goal.unit);
  if (goal.least) return "≥ " + withUnit(*goal.least, goal.unit);
  return goal.most ? "≤ " + withUnit(*goal.most, goal.unit) : std::string();
}

}  // namespace

std::string benchHeader(const BenchFigures& figures) {
  std::string text = "cutis-cli " + figures.version + " bench";
  if (figures.quick) text += " --quick";
  text += ": " + (figures.processor.empty() ? "unknown processor" : figures.processor) + ", " +
          figures.instructionSet + ", " + std::to_string(figures.threads) + " threads\n";
  text += "profile " + figures.profile + ", rig " + figures.rig + ", " +
          std::to_string(figures.pixels) + " pixels of the error protocol; those marked * " +
          std::to_string(figures.subsample) + ", their times a pixel scaled from these\n";
  text +=
      "MSE: mean squared error of reflectance; vis 400-700 nm, UV 300-400 nm, NIR 700-1000 nm.\n"
      "dE: CIEDE2000, median/95 %. A refined fit knows the noise, at 0 it assumes the rig's; "
      "the\n"
      "exact setting believes every digit and is judged without noise alone.\n";
  return text;
}

std::string boundTables(const BenchFigures& figures) {
  return heading("What the paper published") + publishedTable() +
         heading("Bayesian Cramér-Rao bound of the MSE") + boundRows(figures);
}

std::string networkTable(const BenchFigures& figures) {
  if (figures.networks.empty()) {
    return "\nNo networks are built in for this profile; the whole run, without --quick, trains "
           "some.\n";
  }
  std::string text =
      heading(
          "Networks, vis MSE; encode: ChromNN, then the skin model, as fit --method network; + "
          "decode: then SpectraNN") +
      networkErrors(figures.networks) +
      heading(
          "Networks, vis, UV and NIR MSE of SpectraNN by itself, and what a picture takes to the "
          "channels of its rig; work: multiply-adds") +
      networkCosts(figures.networks);
  if (figures.trainingSeconds) {
    text += "  training both for a new rig: " + fixedNumber(*figures.trainingSeconds, 1) + " s\n";
  }
  return text;
}

std::string methodTables(const BenchFigures& figures) {
  std::string text =
      heading("Errors, pixels drawn from the protocol's population") + errorTable(figures.methods);
  if (figures.speedRatio) {
    text += "  three stages, exhaustive, over refined, wide prior, " + usual() + ": " +
            formatNumber(*figures.speedRatio, 3) + " times the time\n";
  }
  for (const std::string& remark : noiseRemarks(figures))
    text += "  " + remark + "\n";
  text += heading("Root mean square errors of parameters, " + usual()) + parameterErrors(figures);
  return text +
         heading("Vis MSE and median dE D65 by skin tone (ITA° over 41, 10, -30, below), " +
                 usual()) +
         toneTable(figures);
}

std::string sampleTable(const BenchFigures& figures) {
  return heading("Errors, pixels of the sample") + errorTable(figures.sample);
}

std::string coverageTables(const BenchFigures& figures) {
  return heading("Truth within two posterior deviations, " + usual() +
                 ", people drawn from the prior; measured: where the deviation is below half the "
                 "prior's") +
         coverageRows(figures);
}

std::string lightTable(const BenchFigures& figures) {
  if (figures.lights.empty()) return {};
  return heading("White light alone against all lights (paper: Fig. 12, pictures only)") +
         variantTable(figures.lights, "lights");
}

std::string parameterTable(const BenchFigures& figures) {
  return heading(
             "Carotene held at 0 against five parameters (paper: Fig. 13, RMSE 0.0311 of a "
             "photograph with four, 0.0164 with five)") +
         variantTable(figures.parameters, "parameters");
}

std::string discrepancyTable(const BenchFigures& figures) {
  if (figures.discrepancy.empty()) return {};
  TextTable table({"noise", "vis MSE", "bound", "/bound", "UV MSE", "bound", "NIR MSE", "bound"});
  for (const DiscrepancyFigures& row : figures.discrepancy) {
    table.add({percent(row.noise), shortScientific(row.errors.visible),
               shortScientific(row.bound.visible), fixedNumber(row.overBound, 2),
               shortScientific(row.errors.ultraviolet), shortScientific(row.bound.ultraviolet),
               shortScientific(row.errors.nearInfrared), shortScientific(row.bound.nearInfrared)});
  }
  return heading(
             "People with what the model leaves over, refined fit that estimates it, and the "
             "bound that includes it") +
         table.text();
}

std::string startTable(const BenchFigures& figures) {
  TextTable table({"start", "vis MSE", "steps", "ns/pixel"});
  for (const StartFigures& row : figures.starts) {
    table.add({row.start, shortScientific(row.visibleMse), fixedNumber(row.meanIterations, 2),
               rounded(row.nanosecondsPerPixel)});
  }
  return heading("Where the refined fit begins, wide prior, " + usual()) + table.text();
}

std::string encodingTable(const BenchFigures& figures) {
  return heading("Kinds of input, refined fit with the population's prior") +
         variantTable(figures.encodings, "input");
}

std::string sizeTable(const BenchFigures& figures) {
  return heading(
             "Whole pictures by size; ~ scaled from the time a pixel above; fit memory: the most "
             "that the fit held besides the photographs") +
         pictureTable(figures.sizes);
}

std::string scalingTable(const BenchFigures& figures) {
  return heading("Whole pictures by threads") + pictureTable(figures.scaling);
}

std::string goalTable(const BenchFigures& figures) {
  const bool otherSet = figures.instructionSet != "avx512";
  TextTable table({"what", "asked", "reached", "met"});
  for (const Goal& goal : goalsOf(figures)) {
    const char* mark = otherSet && goal.presumesAvx512 ? " †" : "";
    table.add({goal.what, askedText(goal) + mark, withUnit(goal.reached, goal.unit),
               goal.isMet() ? "yes" : "no"});
  }
  std::string text = heading("What was to be reached") + table.text();
  if (otherSet) {
    text += "  † asked of two cores with AVX-512; here " + figures.instructionSet + " and " +
            std::to_string(figures.threads) + (figures.threads == 1 ? " thread\n" : " threads\n");
  }
  return text;
}

}  // namespace cutis
