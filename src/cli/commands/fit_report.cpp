#include "src/cli/commands/fit_report.h"

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/base/instruction_set.h"
#include "core/base/parallel.h"
#include "src/app/fit_method.h"
#include "src/files/io/atomic_write.h"
#include "src/files/system/platform.h"

namespace cutis {
namespace {

using Json = nlohmann::ordered_json;

Json pixelCounts(const FitStatistics::Pixels& pixels) {
  return {{"total", pixels.total},
          {"masked", pixels.masked},
          {"invalid", pixels.invalid},
          {"saturated", pixels.saturated},
          {"duplicate", pixels.duplicate},
          {"solved", pixels.solved},
          {"no_convergence", pixels.noConvergence}};
}

Json gamutFigures(const FittedSource& fitted) {
  const auto& pixels = fitted.statistics.pixels;
  const auto estimated = static_cast<double>(pixels.solved + pixels.duplicate);
  Json gamut = {{"outside", std::llround(fitted.gamut.outsideShare * estimated)},
                {"exposure", fitted.source->measurements.exposure}};
  if (fitted.gamut.medianDeltaE) gamut["median_delta_e2000"] = *fitted.gamut.medianDeltaE;
  return gamut;
}

// What the file says of its colours, and what of it was followed.
Json colorFigures(const Source& source) {
  Json statements = Json::array();
  for (const ColorStatement& statement : source.image->colors.statements) {
    Json entry = {{"origin", statement.origin}};
    if (statement.space.empty())
      entry["objection"] = statement.objection;
    else
      entry["says"] = statement.space.name;
    if (!statement.assumption.empty()) entry["assumption"] = statement.assumption;
    statements.push_back(std::move(entry));
  }
  return {{"space", source.colors.followed.space.name},
          {"followed", source.colors.sentence},
          {"statements", std::move(statements)},
          {"contradictions", source.colors.contradictions}};
}

// By name, of the constants that were free.
Json freeFigures(const std::vector<ConstantSummary>& constants) {
  Json free = Json::object();
  for (const ConstantSummary& summary : constants) {
    free[std::string(constantName(summary.constant))] = {{"mean", summary.mean},
                                                         {"p5", summary.low},
                                                         {"p95", summary.high},
                                                         {"open_share", summary.openShare}};
  }
  return free;
}

}  // namespace

Status writeFitReport(const std::filesystem::path& path, const FittedSource& fitted) {
  const FitStatistics& statistics = fitted.statistics;
  const FitSeconds& seconds = fitted.seconds;
  Json root;
  root["method"] = fitMethodName(fitted.options.method);
  root["profile"] = fitted.model->profile().name;
  root["width"] = fitted.source->measurements.width();
  root["height"] = fitted.source->measurements.height();
  root["pixels"] = pixelCounts(statistics.pixels);
  root["iterations"] = {{"mean", statistics.meanIterations}, {"max", statistics.maximumIterations}};
  root["nodes"] = fitted.nodes;
  root["node_error"] = {{"rms", fitted.nodeRms}, {"worst", fitted.nodeWorst}};
  root["seconds"] = {{"load", seconds.load},
                     {"prepare", seconds.prepare},
                     {"fit", seconds.fit},
                     {"write", seconds.write}};
  root["residual"] = {{"mean", statistics.meanResidual}, {"p95", statistics.residual95}};
  root["gamut"] = gamutFigures(fitted);
  if (fitted.source->image && !fitted.source->image->layer.name.empty())
    root["layer"] = fitted.source->image->layer.name;
  if (fitted.source->image) root["colours"] = colorFigures(*fitted.source);
  if (fitted.outsideDiffusion) root["outside_diffusion_share"] = *fitted.outsideDiffusion;
  if (fitted.source->surface.specularShare > 0.0)
    root["specular_share"] = fitted.source->surface.specularShare;
  if (!fitted.constants.empty()) root["free"] = freeFigures(fitted.constants);
  root["threads"] = parallelThreadCount();
  root["isa"] = instructionSetName();
  root["peak_memory_bytes"] = peakMemoryBytes();
  return writeTextAtomically(
      path, root.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace cutis
