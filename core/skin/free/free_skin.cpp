#include "core/skin/free/free_skin.h"

#include <cassert>
#include <cstddef>
#include <utility>

#include "core/skin/profile/profile.h"

namespace cutis {

Result<FreeSkin> FreeSkin::make(const SkinModel& model, std::span<const int> samples,
                                const FreeConstants& free, const JobContext& context,
                                const FreeSkinOptions& options) {
  CUTIS_CHECK(requireFive(model.profile(), "looking for an oxygenation or a thickness"));
  CUTIS_TRY(coordinates, FreeCoordinates::make(model.profile(), free));
  CUTIS_TRY(layers,
            FreeLayers::make(model.profile(), samples, free, context, options.thicknessPoints));
  return FreeSkin(model, samples, std::move(coordinates), std::move(layers), options.edgeLossPerMm);
}

FreeSkin::FreeSkin(const SkinModel& model, std::span<const int> samples,
                   FreeCoordinates coordinates, FreeLayers layers, double edgeLossPerMm)
    : samples_(samples.begin(), samples.end()),
      coordinates_(std::move(coordinates)),
      axes_(model.profile().axes),
      absorption_(model.profile(), samples_, coordinates_.free().oxygenation),
      dermalScattering_(dermalScattering(model.profile())),
      edge_{0.0, 1.0, edgeLossPerMm},
      layers_(std::move(layers)) {}

FreeSpectra FreeSkin::evaluate(std::span<const ParameterVector> parameters,
                               std::span<const SkinConstants> constants, bool derivatives) const {
  assert(parameters.size() == constants.size());
  const std::size_t count = parameters.size(), size = samples_.size() * count;
  std::vector<double> oxygenations(count), thicknesses(count);
  for (std::size_t i = 0; i < count; ++i) {
    oxygenations[i] = constants[i].oxygenation;
    thicknesses[i] = constants[i].thicknessMm;
  }
  auto [epidermal, dermal, blood] = absorption_.at(parameters, oxygenations);
  // The dermis as it acts, and by how much it does so more than its own.
  std::vector<double> acting(size);
  for (std::size_t at = 0; at < size; ++at) {
    const EffectiveAbsorption effective =
        withEdgeLoss(edge_, dermal[at], dermalScattering_[samples_[at / count]]);
    dermal[at] = effective.absorption;
    acting[at] = effective.slope;
  }
  LayerSpectra layers =
      layers_.evaluate({thicknesses.data(), epidermal.data(), dermal.data(), count}, derivatives);
  FreeSpectra spectra;
  spectra.reflectance = std::move(layers.reflectance);
  if (!derivatives) return spectra;
  spectra.perEpidermal = std::move(layers.perEpidermalAbsorption);
  spectra.perDermal = std::move(layers.perDermalAbsorption);
  spectra.perThickness = std::move(layers.perThickness);
  spectra.perOxygenation.resize(size);
  for (std::size_t at = 0; at < size; ++at) {
    const ParameterVector& own = parameters[at % count];
    spectra.perDermal[at] *= acting[at];
    spectra.perOxygenation[at] =
        spectra.perDermal[at] * own[kHaemoglobinDermal] * blood.dermalSlope[at] +
        spectra.perEpidermal[at] * own[kHaemoglobinEpidermal] * blood.epidermalSlope[at];
  }
  spectra.epidermalBlood = std::move(blood.epidermal);
  spectra.dermalBlood = std::move(blood.dermal);
  return spectra;
}

void FreeSkin::byParameters(const FreeSpectra& spectra, std::size_t s, std::size_t i,
                            std::size_t count, const ParameterVector& parameters,
                            ParameterVector& derivatives) const {
  const std::size_t at = s * count + i;
  const LayerPair byAbsorption = {spectra.perEpidermal[at], spectra.perDermal[at]};
  absorption().byParameters(samples_[s], asSpan(parameters), byAbsorption, derivatives.data());
  derivatives[kHaemoglobinDermal] = byAbsorption.dermal * spectra.dermalBlood[at];
  derivatives[kHaemoglobinEpidermal] = byAbsorption.epidermal * spectra.epidermalBlood[at];
}

}  // namespace cutis
