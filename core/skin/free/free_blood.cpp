#include "core/skin/free/free_blood.h"

#include <cmath>
#include <cstddef>

#include "core/maths/weighted_sums.h"
#include "core/skin/profile/chromophore_table.h"
#include "core/skin/profile/free_constants.h"

namespace cutis {
namespace {

ChebyshevWeights weightsOver(double own, bool free) {
  return free ? ChebyshevWeights(0.0, 1.0, kBloodPoints) : ChebyshevWeights(own, own, 1);
}

}  // namespace

FreeBlood::FreeBlood(const Profile& profile, std::span<const int> samples, bool free)
    : profile_(profile),
      free_(free),
      ofDermis_(weightsOver(profile.dermalBlood.oxygenation, free)),
      ofEpidermis_(weightsOver(profile.epidermalBlood.oxygenation, free)),
      dermal_(samples.size() * ofDermis_.points().size()),
      epidermal_(dermal_.size()) {
  Profile changed = profile;
  const std::size_t points = ofDermis_.points().size();
  for (std::size_t k = 0; k < points; ++k) {
    changed.dermalBlood.oxygenation = ofDermis_.points()[k];
    changed.epidermalBlood.oxygenation = ofEpidermis_.points()[k];
    const Spectrum dermal = chromophoreTable()[kHaemoglobinDermal].absorption(changed);
    const Spectrum epidermal = chromophoreTable()[kHaemoglobinEpidermal].absorption(changed);
    for (std::size_t s = 0; s < samples.size(); ++s) {
      dermal_[s * points + k] = dermal[samples[s]];
      epidermal_[s * points + k] = epidermal[samples[s]];
    }
  }
}

FreeBlood::Values FreeBlood::at(std::span<const double> dermalOxygenations) const {
  const std::size_t count = dermalOxygenations.size(), points = ofDermis_.points().size();
  const double difference = profile_.epidermalBlood.oxygenation - profile_.dermalBlood.oxygenation;
  std::vector<double> dermal(count), epidermal(count);
  for (std::size_t i = 0; i < count; ++i) {
    dermal[i] = free_ ? dermalOxygenations[i] : profile_.dermalBlood.oxygenation;
    epidermal[i] = epidermalOxygenation(profile_, dermal[i]);
  }
  const ChebyshevWeights::At ofDermis = ofDermis_.at(dermal);
  ChebyshevWeights::At ofEpidermis = ofEpidermis_.at(epidermal);
  for (std::size_t i = 0; i < count; ++i) {
    if (std::abs(epidermal[i] - dermal[i] - difference) < 1e-12) continue;
    for (std::size_t k = 0; k < points; ++k)
      ofEpidermis.slopes[k * count + i] = 0.0;
  }
  const auto sums = [&](const std::vector<double>& spectra, const std::vector<double>& weights) {
    std::vector<double> values(spectra.size() / points * count);
    runWeightedSums(
        {spectra.data(), spectra.size() / points, points, weights.data(), count, values.data()});
    return values;
  };
  return {sums(dermal_, ofDermis.weights), sums(epidermal_, ofEpidermis.weights),
          sums(dermal_, ofDermis.slopes), sums(epidermal_, ofEpidermis.slopes)};
}

}  // namespace cutis
