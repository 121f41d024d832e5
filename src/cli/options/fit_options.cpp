#include "src/cli/options/fit_options.h"

#include <utility>

#include "core/base/echoed_text.h"
#include "core/base/number_text.h"
#include "core/fit/shading.h"
#include "src/app/fit_method.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/free_options.h"
#include "src/files/networks/network_file.h"
#include "src/files/profiles/profile_file.h"

namespace cutis {
namespace {

constexpr double kLeastExposure = 1e-6;
constexpr double kMostExposure = 1e6;
constexpr double kMostAssumedNoise = 1.0;

// The other methods know neither a prior nor parameters that are held.
Status checkMethodOptions(const FitCommandOptions& options, FitMethod method) {
  if (!options.weights.empty() && method != FitMethod::network) {
    return usageError("--weights", "only the method network takes this; leave it out");
  }
  if (method == FitMethod::refined) return {};
  for (const auto& [option, given] : {std::pair{"--prior", !options.prior.empty()},
                                      {"--fix", !options.fixed.empty()},
                                      {"--noise", !options.noise.empty()},
                                      {"--shading", options.shading},
                                      {"--free", !options.free.empty()},
                                      {"--discrepancy", options.discrepancy == "on"}}) {
    if (given) return usageError(option, "only the method refined takes this; leave it out");
  }
  return {};
}

Status parseExposure(const std::string& text, FitRequest& request) {
  request.exposureIsGiven = !text.empty();
  request.chooseExposure = text.empty() || text == "auto";
  if (request.chooseExposure) return {};
  CUTIS_TRY(exposure, realNumber("--exposure", text, kLeastExposure, kMostExposure));
  request.source.exposure = exposure;
  return {};
}

// Where nothing is said of the surface's reflection, the channels are taken as instruments measure
// skin, with it.
Status parseDiscrepancy(const FitCommandOptions& options, FitOptions& fit) {
  if (!options.measurement.specular.empty()) fit.surface = SurfaceLight::removed;
  if (options.discrepancy.empty()) return {};
  if (options.discrepancy != "on" && options.discrepancy != "off") {
    return usageError("--discrepancy", "must be on or off, not " + inQuotes(options.discrepancy));
  }
  fit.discrepancy = options.discrepancy == "on";
  if (*fit.discrepancy && fit.free.count() > 0) {
    return usageError("--discrepancy",
                      "this does not go with --free, which explains with constants what would be "
                      "left over; leave one of them out");
  }
  return {};
}

}  // namespace

void addFitOptions(CLI::App& command, FitCommandOptions& options) {
  addOption(command, "--method", options.method, "METHOD",
            "refined (default): exact physics, most probable values; three-stage and "
            "full-search: nearest entry of the table of skin; network: what a trained "
            "network answers, the fastest");
  addProfileOption(command, options.profile, kDefaultProfile);
  addOption(command, "--rig", options.rig, "NAME|FILE",
            "Camera and lights: a built-in name or a JSON file (default: what the capture "
            "names; albedo for an image)");
  addOption(command, "--lights", options.lights, "LIGHT,...",
            "Lights of the capture to use, separated by commas (default: all)");
  addOption(command, "--layer", options.layer, "NAME",
            "Layer or part of an OpenEXR image, as info lists them (default: the plain channels R, "
            "G and B)");
  addOption(command, "--exposure", options.exposure, "S|auto",
            "Factor on the linear values of an image (default: auto, the one that brings most "
            "pixels into the profile's range of skin colours, and 1 unless another brings five "
            "in a hundred more)");
  addOption(command, "--noise", options.noise, "READ,PROP",
            "Standard deviations of a channel, constant and proportional, where the "
            "perfect diffuser reads 1; 0,0 asks for the exact solution (default: the "
            "rig's, 0.0001,0.005 for the built-in ones)");
  addOption(command, "--prior", options.prior, "FILE",
            "JSON file with what is known of the skin beforehand (default: the profile's)");
  addOption(command, "--fix", options.fixed, "NAME=VALUE",
            "Hold a parameter at a value in its unit instead of estimating it, such as "
            "carotene=0; may be repeated")
      ->allow_extra_args(false);
  command.add_flag("--shading", options.shading,
                   "Estimate one more factor per pixel on all channels, for photographs that are "
                   "not pure albedo; fit writes it beside the maps");
  addOption(command, "--free", options.free, "NAMES",
            "Constants of the profile to find for each pixel, too: oxygenation (of the "
            "dermis's blood; that of the epidermis moves along), thickness (of the epidermis), "
            "or both with a comma; takes at least as many independent channels as there are "
            "values to find, 6 or 7 (default: none)");
  addOption(
      command, "--discrepancy", options.discrepancy, "on|off",
      "Whether to estimate what the profile's model leaves over of measured skin, which brings "
      "spectra nearer to those of real people (default: on where the profile knows it, off "
      "with --free, for captures of simulate, and with --noise 0,0, which takes photographs "
      "for the model's own)");
  addOption(command, "--weights", options.weights, "NAME|FILE",
            "Networks for the method network: a file that train has written, or a built-in "
            "name, such as monitor-5, which takes the paper's five channels (default: those "
            "built in for all channels of the rig)");
  addSpecularOptions(command, "photographs", options.measurement);
}

std::string firstGiven(const FitCommandOptions& options) {
  for (const auto& [option, text] : {std::pair{"--method", options.method},
                                     {"--profile", options.profile},
                                     {"--rig", options.rig},
                                     {"--lights", options.lights},
                                     {"--exposure", options.exposure},
                                     {"--noise", options.noise},
                                     {"--prior", options.prior},
                                     {"--free", options.free},
                                     {"--discrepancy", options.discrepancy},
                                     {"--weights", options.weights},
                                     {"--specular", options.measurement.specular},
                                     {"--specular-share", options.measurement.share}}) {
    if (!text.empty()) return option;
  }
  if (!options.fixed.empty()) return "--fix";
  if (options.shading) return "--shading";
  return options.layer.empty() ? "" : "--layer";
}

Result<FitRequest> parseFitOptions(const FitCommandOptions& options) {
  FitRequest request;
  request.profile = options.profile.empty() ? kDefaultProfile : options.profile;
  request.methodName = options.method.empty() ? fitMethodName(FitMethod::refined) : options.method;
  CUTIS_TRY(method, fitMethodNamed(request.methodName, "--method"));
  request.options.method = method;
  CUTIS_CHECK(checkMethodOptions(options, method));
  request.source.rig = options.rig;
  request.source.lights = commaSeparated(options.lights);
  request.source.layer = options.layer;
  CUTIS_CHECK(parseExposure(options.exposure, request));
  if (!options.noise.empty()) {
    CUTIS_TRY(noise, realNumbers("--noise", options.noise, 2, 0.0, kMostAssumedNoise));
    request.options.noise = NoiseModel{noise[0], noise[1]};
  }
  CUTIS_TRY(measurement, parseMeasurement(options.measurement));
  request.measurement = measurement;
  if (options.shading && measurement.specular == SpecularPart::included) {
    return usageError("--shading",
                      "shading and the surface reflection cannot be told apart; leave out one "
                      "of --shading and --specular");
  }
  request.priorFile = options.prior;
  request.weightsFile = options.weights;
  if (options.shading) request.options.shading = kUsualShadingDeviation;
  CUTIS_TRY(free, freeConstants("--free", options.free));
  request.options.free = free;
  if (options.shading && free.count() > 0) {
    return usageError("--free",
                      "this does not go with --shading, which looks much like it in the "
                      "channels; leave one of them out");
  }
  CUTIS_CHECK(parseDiscrepancy(options, request.options));
  for (const std::string& text : options.fixed) {
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
  if (options.discrepancy.value_or(false) && profile.discrepancies.of(options.surface) == nullptr) {
    const std::string surface =
        profile.discrepancies.empty()
            ? std::string()
            : " where the surface's reflection is " + surfaceLightName(options.surface);
    return usageError("--discrepancy",
                      "the profile " + inQuotes(profile.name) +
                          " does not know what its model leaves over" + surface +
                          "; leave this out, or choose one that does, such as --profile " +
                          kDefaultProfile);
  }
  if (!request.priorFile.empty()) {
    CUTIS_TRY(prior, readPrior(request.priorFile, profile.prior));
    options.prior = prior;
  }
  if (!request.weightsFile.empty()) {
    CUTIS_TRY(networks, loadNetworks(request.weightsFile, profile, "--weights"));
    options.network = std::make_shared<const ChromophoreNetwork>(std::move(networks.chromophores));
  }
  return {};
}

std::vector<std::string> filesRead(const FitRequest& request) {
  return {request.profile, request.source.rig, request.source.mask.string(), request.priorFile,
          request.weightsFile};
}

}  // namespace cutis
