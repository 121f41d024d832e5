#include "core/fit/fit_record.h"

#include <cmath>
#include <cstddef>

#include "core/fit/assumed_noise.h"
#include "core/fit/discrepancy_choice.h"

namespace cutis {

FitRecord fitRecord(const Profile& profile, const Rig& rig, const FitOptions& options) {
  FitRecord record;
  for (const RigLight& light : rig.lights)
    record.lights.push_back(light.name);
  for (int k = 0; k < rig.channelCount(); ++k)
    record.channels.push_back(rig.channelName(k));
  record.responses = responseRows(rig);
  record.noise = assumedNoise(rig, options);
  record.prior = assumedPrior(profile, rig, options);
  record.fixed = options.fixed;
  record.free = options.free;
  record.shading = options.shading;
  record.surface = options.surface;
  record.discrepancy = chosenDiscrepancy(profile, rig, options) != nullptr;
  return record;
}

Status validate(const FitRecord& record, const Profile& profile, const std::string& place) {
  const auto wrong = [&](const std::string& what) {
    return inputError(place, what + "; fit the image again");
  };
  if (record.channels.empty() ||
      static_cast<Eigen::Index>(record.channels.size()) != record.responses.rows()) {
    return wrong("every channel needs a response");
  }
  if (!record.responses.isFinite().all() || (record.responses < 0.0).any())
    return wrong("responses must be finite and not negative");
  for (const double noise : {record.noise.read, record.noise.proportional, record.noise.veil}) {
    if (!(std::isfinite(noise) && noise >= 0.0)) return wrong("noise must be 0 or more");
  }
  if (!(record.noise.read > 0.0)) return wrong("the constant part of the noise must be positive");
  if (record.shading && !(std::isfinite(*record.shading) && *record.shading > 0.0))
    return wrong("the deviation of the shading must be positive");
  for (std::size_t k = 0; k < record.fixed.size(); ++k) {
    if (!record.fixed[k]) continue;
    if (!(*record.fixed[k] >= 0.0 && *record.fixed[k] <= profile.axes[k].maximum))
      return wrong("a held parameter lies outside of its range");
  }
  if (record.discrepancy && profile.discrepancies.of(record.surface) == nullptr)
    return wrong("the profile does not know the discrepancy that was estimated");
  return validate(record.prior, place, "prior.");
}

}  // namespace cutis
