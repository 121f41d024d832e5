#include "src/cli/commands/bench/bench_report.h"

#include <nlohmann/json.hpp>

#include "src/bench/goals.h"
#include "src/files/io/atomic_write.h"

namespace cutis {
namespace {

using Json = nlohmann::ordered_json;

Json byParameter(const ParameterVector& values) {
  Json object;
  for (const Parameter parameter : kParameters)
    object[std::string(parameterName(parameter))] = values[parameter];
  return object;
}

Json errorsOf(const ErrorSummary& errors) {
  return {{"pixels", errors.pixels},
          {"visible_mse", errors.visibleMse},
          {"ultraviolet_mse", errors.ultravioletMse},
          {"near_infrared_mse", errors.nearInfraredMse},
          {"delta_e2000_d65", {{"median", errors.medianDeltaE_D65}, {"p95", errors.deltaE95_D65}}},
          {"delta_e2000_a", {{"median", errors.medianDeltaE_A}, {"p95", errors.deltaE95_A}}},
          {"parameter_rmse", byParameter(errors.parameterRmse)}};
}

Json boundOf(const ErrorBound& bound) {
  return {{"visible_mse", bound.visible},
          {"ultraviolet_mse", bound.ultraviolet},
          {"near_infrared_mse", bound.nearInfrared}};
}

Json methodsOf(const std::vector<MethodFigures>& methods) {
  Json array = Json::array();
  for (const MethodFigures& row : methods) {
    Json object = {{"method", methodKey(row.method)},
                   {"noise", row.noise},
                   {"scaled_from_subsample", isExhaustive(row.method)},
                   {"ns_per_pixel", row.nanosecondsPerPixel},
                   {"errors", errorsOf(row.errors)}};
    if (isRefined(row.method)) {
      object["mean_iterations"] = row.meanIterations;
      object["unconverged_share"] = row.unconvergedShare;
    }
    if (row.overBound) object["over_bound"] = *row.overBound;
    for (int tone = 0; tone < kToneCount; ++tone)
      object["tones"][toneName(tone)] = errorsOf(row.tones[static_cast<std::size_t>(tone)]);
    array.push_back(object);
  }
  return array;
}

Json boundsOf(const std::vector<BoundFigures>& bounds) {
  Json array = Json::array();
  for (const BoundFigures& row : bounds) {
    Json object = boundOf(row.bound);
    object["noise"] = row.noise;
    if (row.printed) object["visible_mse_as_designed"] = *row.printed;
    array.push_back(object);
  }
  return array;
}

Json coverageOf(const std::vector<CoverageFigures>& coverage) {
  Json array = Json::array();
  const auto counts = [](const auto& all) {
    Json object;
    for (const Parameter parameter : kParameters) {
      const Coverage::Count& count = all[static_cast<std::size_t>(parameter)];
      object[std::string(parameterName(parameter))] = {{"pixels", count.pixels},
                                                       {"inside", count.inside}};
    }
    return object;
  };
  // Null where there is nothing to have a share of.
  const auto shareOf = [](const auto& all) -> Json {
    const Coverage::Count count = pooled(all);
    return count.pixels == 0 ? Json() : Json(count.share());
  };
  for (const CoverageFigures& row : coverage) {
    array.push_back({{"prior", row.prior},
                     {"noise", row.noise},
                     {"measured", counts(row.coverage.measured)},
                     {"elsewhere", counts(row.coverage.assumed)},
                     {"measured_share", shareOf(row.coverage.measured)},
                     {"elsewhere_share", shareOf(row.coverage.assumed)}});
  }
  return array;
}

Json variantsOf(const std::vector<VariantFigures>& variants) {
  Json array = Json::array();
  for (const VariantFigures& row : variants) {
    Json object = {
        {"variant", row.variant}, {"noise", row.noise}, {"errors", errorsOf(row.errors)}};
    if (row.bound) object["bound"] = boundOf(*row.bound);
    array.push_back(object);
  }
  return array;
}

Json picturesOf(const std::vector<PictureFigures>& pictures) {
  Json array = Json::array();
  for (const PictureFigures& row : pictures) {
    Json object = {{"content", row.content}, {"method", methodKey(row.method)},
                   {"size", row.size},       {"noise", row.noise},
                   {"threads", row.threads}, {"seconds", row.seconds},
                   {"scaled", row.scaled}};
    if (!row.scaled) {
      object["solved"] = row.solved;
      object["duplicate"] = row.duplicate;
      object["mean_iterations"] = row.meanIterations;
      if (row.memoryBytes) object["fit_memory_bytes"] = *row.memoryBytes;
    }
    array.push_back(object);
  }
  return array;
}

Json networksOf(const std::vector<NetworkFigures>& networks) {
  Json array = Json::array();
  for (const NetworkFigures& row : networks) {
    Json object = {{"lights", row.lights},
                   {"channels", row.channels},
                   {"weights", row.weights},
                   {"multiply_adds_per_pixel", row.workPerPixel},
                   {"spectra_network",
                    {{"visible_mse", row.decoded.visible},
                     {"ultraviolet_mse", row.decoded.ultraviolet},
                     {"near_infrared_mse", row.decoded.nearInfrared}}},
                   {"size", row.size},
                   {"encode_seconds", row.encodeSeconds},
                   {"encode_decode_seconds", row.bothSeconds}};
    for (const NetworkFigures::AtNoise& at : row.errors) {
      object["errors"].push_back({{"noise", at.noise},
                                  {"encode_visible_mse", at.encodedMse},
                                  {"encode_decode_visible_mse", at.bothMse}});
    }
    array.push_back(object);
  }
  return array;
}

Json startsOf(const std::vector<StartFigures>& starts) {
  Json array = Json::array();
  for (const StartFigures& row : starts) {
    array.push_back({{"start", row.start},
                     {"visible_mse", row.visibleMse},
                     {"mean_iterations", row.meanIterations},
                     {"ns_per_pixel", row.nanosecondsPerPixel}});
  }
  return array;
}

Json discrepancyRows(const std::vector<DiscrepancyFigures>& figures) {
  const auto bands = [](const ErrorBound& errors) {
    return Json{{"visible", errors.visible},
                {"ultraviolet", errors.ultraviolet},
                {"near_infrared", errors.nearInfrared}};
  };
  Json array = Json::array();
  for (const DiscrepancyFigures& row : figures) {
    array.push_back({{"noise", row.noise},
                     {"mse", bands(row.errors)},
                     {"bound", bands(row.bound)},
                     {"over_bound", row.overBound}});
  }
  return array;
}

Json publishedFigures() {
  Json array = Json::array();
  for (const PublishedFigures& row : kPublished) {
    array.push_back({{"method", row.method},
                     {"seconds_2048", row.secondsFor2048},
                     {"visible_mse", row.visibleMse}});
  }
  return array;
}

Json goalsIn(const BenchFigures& figures) {
  Json array = Json::array();
  for (const Goal& goal : goalsOf(figures)) {
    Json object = {{"goal", goal.key}, {"what", goal.what}};
    if (goal.least) object["least"] = *goal.least;
    if (goal.most) object["most"] = *goal.most;
    object["reached"] = goal.reached;
    object["met"] = goal.isMet();
    object["presumes_avx512"] = goal.presumesAvx512;
    array.push_back(object);
  }
  return array;
}

}  // namespace

Status writeBenchReport(const std::filesystem::path& path, const BenchFigures& figures) {
  Json root = {{"version", figures.version},    {"processor", figures.processor},
               {"isa", figures.instructionSet}, {"threads", figures.threads},
               {"profile", figures.profile},    {"rig", figures.rig},
               {"pixels", figures.pixels},      {"subsample", figures.subsample},
               {"quick", figures.quick}};
  root["bounds"] = boundsOf(figures.bounds);
  root["methods"] = methodsOf(figures.methods);
  root["sample"] = methodsOf(figures.sample);
  root["networks"] = networksOf(figures.networks);
  if (figures.trainingSeconds) root["training_seconds"] = *figures.trainingSeconds;
  root["coverage"] = coverageOf(figures.coverage);
  root["lights"] = variantsOf(figures.lights);
  root["parameters"] = variantsOf(figures.parameters);
  if (!figures.discrepancy.empty()) root["discrepancy"] = discrepancyRows(figures.discrepancy);
  root["starts"] = startsOf(figures.starts);
  root["encodings"] = variantsOf(figures.encodings);
  root["sizes"] = picturesOf(figures.sizes);
  root["scaling"] = picturesOf(figures.scaling);
  root["published"] = publishedFigures();
  if (figures.firstPicture) {
    root["first_picture"] = {{"size", figures.firstPicture->size},
                             {"seconds", figures.firstPicture->seconds}};
  }
  root["goals"] = goalsIn(figures);
  if (figures.speedRatio) root["speed_ratio"] = *figures.speedRatio;
  return writeTextAtomically(
      path, root.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace cutis
