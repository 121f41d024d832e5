#include "core/skin/free/free_absorption.h"

#include <cassert>
#include <cstddef>

namespace cutis {

FreeAbsorption::FreeAbsorption(const Profile& profile, std::span<const int> samples,
                               bool freeOxygenation)
    : samples_(samples.begin(), samples.end()),
      law_(profile),
      blood_(profile, samples_, freeOxygenation) {
  assert(profile.further.empty());
}

FreeAbsorption::Values FreeAbsorption::at(std::span<const ParameterVector> parameters,
                                          std::span<const double> dermalOxygenations) const {
  assert(parameters.size() == dermalOxygenations.size());
  const std::size_t count = parameters.size(), size = samples_.size() * count;
  Values values = {std::vector<double>(size), std::vector<double>(size),
                   blood_.at(dermalOxygenations)};
  std::vector<ParameterVector> bloodless(parameters.begin(), parameters.end());
  for (ParameterVector& own : bloodless)
    own[kHaemoglobinDermal] = own[kHaemoglobinEpidermal] = 0.0;
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = s * count + i;
      const LayerPair without = law_.at(samples_[s], bloodless[i]);
      values.epidermal[at] =
          without.epidermal + parameters[i][kHaemoglobinEpidermal] * values.blood.epidermal[at];
      values.dermal[at] =
          without.dermal + parameters[i][kHaemoglobinDermal] * values.blood.dermal[at];
    }
  }
  return values;
}

}  // namespace cutis
