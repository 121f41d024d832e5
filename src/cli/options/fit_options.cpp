#include "src/cli/options/fit_options.h"

#include <utility>

#include "core/fit/shading.h"
#include "src/app/fit_method.h"
#include "src/cli/options/free_options.h"
#include "src/files/io/csv.h"
#include "src/files/networks/network_file.h"
#include "src/files/profiles/profile_file.h"

namespace cutis {
namespace {

constexpr double kLeastExposure = 1e-6;
constexpr double kMostExposure = 1e6;
constexpr double kMostAssumedNoise = 1.0;

// The other methods know neither a prior nor parameters that are held.
Status checkMethodOptions(const FitArguments& arguments, FitMethod method) {
  if (!arguments.weights.empty() && method != FitMethod::network) {
    return usageError("--weights", "only the method network takes this; leave it out");
  }
  if (method == FitMethod::refined) return {};
  for (const auto& [option, given] : {std::pair{"--prior", !arguments.prior.empty()},
                                      {"--fix", !arguments.fixed.empty()},
                                      {"--noise", !arguments.noise.empty()},
                                      {"--shading", arguments.shading},
                                      {"--free", !arguments.free.empty()}}) {
    if (given) return usageError(option, "only the method refined takes this; leave it out");
  }
  return {};
}

Status parseExposure(const std::string& text, FitRequest& request) {
  if (text == "auto") {
    request.chooseExposure = true;
  } else if (!text.empty()) {
    CUTIS_TRY(exposure, realNumber("--exposure", text, kLeastExposure, kMostExposure));
    request.source.exposure = exposure;
  }
  return {};
}

}  // namespace

void addFitArguments(CLI::App& command, FitArguments& arguments) {
  command
      .add_option("--method", arguments.method,
                  "refined (default): exact physics, most probable values; three-stage and "
                  "full-search: nearest entry of the table of skin; network: what a trained "
                  "network answers, the fastest")
      ->type_name("METHOD");
  command
      .add_option("--profile", arguments.profile,
                  "Skin model: a built-in name or a JSON file (default: skin2026)")
      ->type_name("NAME|FILE");
  command
      .add_option("--rig", arguments.rig,
                  "Camera and lights: a built-in name or a JSON file (default: what the capture "
                  "names; albedo for an image)")
      ->type_name("NAME|FILE");
  command
      .add_option("--lights", arguments.lights,
                  "Lights of the capture to use, with commas between them (default: all)")
      ->type_name("LIGHT,...");
  command
      .add_option("--exposure", arguments.exposure,
                  "Factor on the linear values of an image; auto chooses the one that brings "
                  "most pixels into the profile's range of skin colours (default: 1)")
      ->type_name("S|auto");
  command
      .add_option("--noise", arguments.noise,
                  "Standard deviations of a channel, constant and proportional, where the "
                  "perfect diffuser reads 1; 0,0 asks for the exact solution (default: the "
                  "rig's, 0.0001,0.005 for the built-in ones)")
      ->type_name("READ,PROP");
  command
      .add_option("--prior", arguments.prior,
                  "JSON file with what is known of the skin beforehand (default: the profile's)")
      ->type_name("FILE");
  command
      .add_option("--fix", arguments.fixed,
                  "Hold a parameter at a value in its unit instead of estimating it, such as "
                  "carotene=0; may be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command.add_flag("--shading", arguments.shading,
                   "Estimate one more factor per pixel on all channels, for photographs that are "
                   "not pure albedo; fit writes it beside the maps");
  command
      .add_option(
          "--free", arguments.free,
          "Constants of the profile to find for each pixel, too: oxygenation (of the "
          "dermis's blood; that of the epidermis moves along), thickness (of the epidermis), "
          "or both with a comma; takes at least as many independent channels as there are "
          "values to find, 6 or 7 (default: none)")
      ->type_name("NAMES");
  command
      .add_option("--weights", arguments.weights,
                  "Networks for the method network: a file that train has written, or a built-in "
                  "name, such as monitor-5, which takes the paper's five channels (default: those "
                  "built in for all channels of the rig)")
      ->type_name("NAME|FILE");
  addSpecularOptions(command, "photographs", arguments.measurement);
}

std::string firstGiven(const FitArguments& arguments) {
  for (const auto& [option, text] : {std::pair{"--method", arguments.method},
                                     {"--profile", arguments.profile},
                                     {"--rig", arguments.rig},
                                     {"--lights", arguments.lights},
                                     {"--exposure", arguments.exposure},
                                     {"--noise", arguments.noise},
                                     {"--prior", arguments.prior},
                                     {"--free", arguments.free},
                                     {"--weights", arguments.weights},
                                     {"--specular", arguments.measurement.specular},
                                     {"--specular-share", arguments.measurement.share}}) {
    if (!text.empty()) return option;
  }
  if (!arguments.fixed.empty()) return "--fix";
  return arguments.shading ? "--shading" : "";
}

Result<FitRequest> parseFitArguments(const FitArguments& arguments) {
  FitRequest request;
  request.profile = arguments.profile.empty() ? kDefaultProfile : arguments.profile;
  request.methodName =
      arguments.method.empty() ? fitMethodName(FitMethod::refined) : arguments.method;
  CUTIS_TRY(method, fitMethodNamed(request.methodName, "--method"));
  request.options.method = method;
  CUTIS_CHECK(checkMethodOptions(arguments, method));
  request.source.rig = arguments.rig;
  request.source.lights = commaSeparated(arguments.lights);
  CUTIS_CHECK(parseExposure(arguments.exposure, request));
  if (!arguments.noise.empty()) {
    CUTIS_TRY(noise, realNumbers("--noise", arguments.noise, 2, 0.0, kMostAssumedNoise));
    request.options.noise = NoiseModel{noise[0], noise[1]};
  }
  CUTIS_TRY(measurement, parseMeasurement(arguments.measurement));
  request.measurement = measurement;
  if (arguments.shading && measurement.specular == SpecularPart::included) {
    return usageError("--shading",
                      "shade and the reflection of the surface cannot be told apart; leave out one "
                      "of --shading and --specular");
  }
  request.priorFile = arguments.prior;
  request.weightsFile = arguments.weights;
  if (arguments.shading) request.options.shading = kUsualShadingDeviation;
  CUTIS_TRY(free, freeConstants("--free", arguments.free));
  request.options.free = free;
  if (arguments.shading && free.count() > 0) {
    return usageError("--free",
                      "this does not go with --shading, which looks much like it in the "
                      "channels; leave one of them out");
  }
  for (const std::string& text : arguments.fixed) {
    CUTIS_TRY(fixed, assignment("--fix", text));
    request.fixed.push_back(fixed);
  }
  return request;
}

Status completeFitOptions(const FitRequest& request, const Profile& profile, FitOptions& options) {
  for (const Assignment& fixed : request.fixed) {
    const auto k = static_cast<std::size_t>(fixed.parameter);
    const std::string name(parameterName(fixed.parameter));
    const double most = profile.axes[k].maximum;
    if (fixed.value < 0.0 || fixed.value > most) {
      return usageError("--fix", name + "=" + formatNumber(fixed.value) +
                                     " is out of range; give a value from 0 to " +
                                     formatNumber(most));
    }
    if (options.fixed[k]) return usageError("--fix", name + " is given twice; give it once");
    options.fixed[k] = fixed.value;
  }
  if (request.fixed.size() == kParameterCount) {
    return usageError("--fix", "all five parameters are held; leave at least one to be estimated");
  }
  if (!request.priorFile.empty()) {
    CUTIS_TRY(prior, readPrior(request.priorFile, profile.prior));
    options.prior = prior;
  }
  if (!request.weightsFile.empty()) {
    CUTIS_TRY(networks, loadNetworks(request.weightsFile, profile.name, "--weights"));
    options.network = std::make_shared<const ChromophoreNetwork>(std::move(networks.chromophores));
  }
  return {};
}

std::vector<std::string> filesRead(const FitRequest& request) {
  return {request.profile, request.source.rig, request.source.mask.string(), request.priorFile,
          request.weightsFile};
}

}  // namespace cutis
