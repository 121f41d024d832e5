#include "src/app/open/fit_choice.h"

#include <algorithm>
#include <cmath>

#include "core/base/echoed_text.h"
#include "core/base/number_text.h"
#include "core/fit/shading.h"
#include "core/rig/surface_reflection.h"
#include "src/files/profiles/prior_file.h"

namespace cutis {

namespace {

bool isHeld(const std::optional<double>& value) {
  return value.has_value();
}

Status checkShading(const FitChoice& choice, const Source& source) {
  if (!choice.shading) return {};
  if (choice.method != FitMethod::refined) {
    return usageError("Shading",
                      "only the method refined can estimate it; choose that, or leave "
                      "shading out");
  }
  if (source.image) {
    return usageError("Shading",
                      "a texture is taken as albedo without shades; open photographs "
                      "under several lights to estimate it");
  }
  if (choice.free.count() > 0) {
    return usageError("Shading",
                      "it does not go with constants found per pixel; leave one of them out");
  }
  return {};
}

Status checkExposure(const FitChoice& choice, const Source& source) {
  if (!choice.exposure) return {};
  if (!std::isfinite(*choice.exposure) || !(*choice.exposure > 0.0)) {
    return usageError("Exposure", "it must be a positive number");
  }
  if (!source.image && *choice.exposure != 1.0) {
    return usageError("Exposure", "photographs are calibrated; this is for single images");
  }
  return {};
}

bool hasReflection(const FitChoice& choice) {
  return choice.specular == SpecularPart::included && choice.specularShare > 0.0;
}

Status checkReflection(const FitChoice& choice, const Source& source) {
  if (!hasReflection(choice)) return {};
  if (source.image) {
    return usageError("Surface reflection",
                      "a single image is taken as albedo, without it; this is for captures");
  }
  if (choice.shading) {
    return usageError("Surface reflection",
                      "it cannot be told apart from shading; leave one of them out");
  }
  return {};
}

Status checkHeld(const std::array<std::optional<double>, kParameterCount>& held,
                 const Profile& profile) {
  if (std::all_of(held.begin(), held.end(), isHeld)) {
    return usageError("Held parameters", "all five are held; leave at least one to be estimated");
  }
  for (const Parameter k : kParameters) {
    const auto& value = held[static_cast<std::size_t>(k)];
    const double most = profile.axes[static_cast<std::size_t>(k)].maximum;
    if (value && !(*value >= 0.0 && *value <= most)) {
      return usageError("Held parameters",
                        std::string(parameterName(k)) + " of " + formatNumber(*value) +
                            " is out of range; give a value from 0 to " + formatNumber(most));
    }
  }
  return {};
}

}  // namespace

bool FitChoice::hasRefinements() const {
  return noise || !prior.empty() || std::any_of(fixed.begin(), fixed.end(), isHeld) ||
         free.count() > 0 || discrepancy.value_or(false);
}

MeasurementGeometry surfaceOf(const FitChoice& choice, const Profile& profile) {
  if (!hasReflection(choice)) return {};
  return measurementGeometry(SpecularPart::included, profile.refractiveIndex, choice.specularShare);
}

bool needsReading(const FitChoice& now, const FitChoice& next) {
  if (hasReflection(now) != hasReflection(next)) return true;
  return hasReflection(next) &&
         (now.specularShare != next.specularShare || now.profile != next.profile);
}

std::shared_ptr<const Source> atChosenExposure(const std::shared_ptr<const Source>& source,
                                               const FitChoice& choice) {
  if (!choice.exposure || !source->image) return source;
  auto exposed = std::make_shared<Source>(*source);  // planes are handles
  exposed->measurements.exposure = *choice.exposure;
  return exposed;
}

Status checkFitChoice(const FitChoice& choice, const Source& source) {
  CUTIS_CHECK(checkExposure(choice, source));
  CUTIS_CHECK(checkReflection(choice, source));
  if (choice.method != FitMethod::refined && choice.hasRefinements()) {
    return usageError("Fit options",
                      "only the method refined knows noise, priors, parameters that are held, "
                      "free constants and the discrepancy; choose that, or reset the options");
  }
  if (choice.free.count() > 0 && choice.discrepancy.value_or(false)) {
    return usageError("Discrepancy",
                      "it does not go with free constants, which explain what would be left "
                      "over; leave one of them out");
  }
  return checkShading(choice, source);
}

Result<FitOptions> fitOptions(const FitChoice& choice, const Profile& profile) {
  FitOptions options;
  options.method = choice.method;
  if (choice.shading) options.shading = kUsualShadingDeviation;
  if (choice.specular) options.surface = SurfaceLight::removed;
  if (choice.noise) {
    options.noise =
        noiseBelowSurface({(*choice.noise)[0], (*choice.noise)[1]}, surfaceOf(choice, profile));
  }
  if (!choice.prior.empty()) {
    CUTIS_TRY(prior, readPrior(choice.prior, profile.prior));
    options.prior = prior;
  }
  CUTIS_CHECK(checkHeld(choice.fixed, profile));
  options.fixed = choice.fixed;
  options.free = choice.free;
  options.discrepancy = choice.discrepancy;
  if (choice.discrepancy.value_or(false) && profile.discrepancies.of(options.surface) == nullptr) {
    return usageError("Discrepancy", "the profile " + inQuotes(profile.name) +
                                         " does not know what its model leaves over; choose "
                                         "another profile, or leave this out");
  }
  return options;
}

}  // namespace cutis
