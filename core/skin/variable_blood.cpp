#include "core/skin/variable_blood.h"

#include <cmath>
#include <cstddef>

#include "core/skin/absorption.h"
#include "core/skin/free_constants.h"

namespace cutis {
namespace {

ChebyshevWeights weightsOver(double own, bool free) {
  return free ? ChebyshevWeights(0.0, 1.0, kBloodPoints) : ChebyshevWeights(own, own, 1);
}

}  // namespace

VariableBlood::VariableBlood(const Profile& profile, std::span<const int> samples, bool free)
    : profile_(profile),
      free_(free),
      ofDermis_(weightsOver(profile.dermalBlood.oxygenation, free)),
      ofEpidermis_(weightsOver(profile.epidermalBlood.oxygenation, free)),
      dermal_(static_cast<Eigen::Index>(samples.size()), ofDermis_.count()),
      epidermal_(dermal_.rows(), ofEpidermis_.count()) {
  Profile changed = profile;
  for (int k = 0; k < ofDermis_.count(); ++k) {
    const auto point = static_cast<std::size_t>(k);
    changed.dermalBlood.oxygenation = ofDermis_.points()[point];
    changed.epidermalBlood.oxygenation = ofEpidermis_.points()[point];
    const Spectrum dermal = dermalAbsorption(changed).blood;
    const Spectrum epidermal = epidermalAbsorption(changed).blood;
    for (Eigen::Index s = 0; s < dermal_.rows(); ++s) {
      const int sample = samples[static_cast<std::size_t>(s)];
      dermal_(s, k) = dermal[sample];
      epidermal_(s, k) = epidermal[sample];
    }
  }
}

VariableBlood::Values VariableBlood::at(std::span<const double> dermalOxygenations) const {
  const std::size_t count = dermalOxygenations.size();
  const std::size_t size = static_cast<std::size_t>(dermal_.rows()) * count;
  Values values;
  for (auto* column : {&values.dermal, &values.epidermal, &values.dermalSlope,
                       &values.epidermalSlope}) {
    column->resize(size);
  }
  const double difference =
      profile_.epidermalBlood.oxygenation - profile_.dermalBlood.oxygenation;
  for (std::size_t i = 0; i < count; ++i) {
    const double dermal = free_ ? dermalOxygenations[i] : profile_.dermalBlood.oxygenation;
    const double epidermal = epidermalOxygenation(profile_, dermal);
    const ChebyshevWeights::At d = ofDermis_.at(dermal), e = ofEpidermis_.at(epidermal);
    const bool follows = std::abs(epidermal - dermal - difference) < 1e-12;
    for (Eigen::Index s = 0; s < dermal_.rows(); ++s) {
      const std::size_t at = static_cast<std::size_t>(s) * count + i;
      values.dermal[at] = dermal_.row(s).dot(d.weights);
      values.dermalSlope[at] = dermal_.row(s).dot(d.slopes);
      values.epidermal[at] = epidermal_.row(s).dot(e.weights);
      values.epidermalSlope[at] = follows ? epidermal_.row(s).dot(e.slopes) : 0.0;
    }
  }
  return values;
}

}  // namespace cutis
