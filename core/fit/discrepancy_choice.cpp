#include "core/fit/discrepancy_choice.h"

#include "core/fit/assumed_noise.h"

namespace cutis {

const Discrepancy* chosenDiscrepancy(const Profile& profile, const Rig& rig,
                                     const FitOptions& options) {
  const bool mayHaveOne = options.method == FitMethod::refined && options.free.count() == 0;
  if (!mayHaveOne || !options.discrepancy.value_or(!asksForExact(rig, options))) return nullptr;
  return profile.discrepancies.of(options.surface);
}

FitOptions suitedTo(const Measurements& measurements, FitOptions options) {
  if (measurements.isSimulated && !options.discrepancy) options.discrepancy = false;
  return options;
}

Prior assumedPrior(const Profile& profile, const Rig& rig, const FitOptions& options) {
  if (options.prior) return *options.prior;
  const Discrepancy* discrepancy = chosenDiscrepancy(profile, rig, options);
  return discrepancy == nullptr ? profile.prior : discrepancy->prior;
}

}  // namespace cutis
