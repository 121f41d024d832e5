#include "src/app/document/place_parts.h"

#include "core/skin/profile/absorption.h"

namespace cutis {
namespace {

// The blend is a share, not a concentration.
constexpr Parameter kConcentrations[] = {kMelanin, kHaemoglobinDermal, kHaemoglobinEpidermal,
                                         kCarotene};

}  // namespace

PlaceParts placeParts(const SkinModel& model, const PlaceSpectra& place) {
  const ParameterVector& parameters = place.editedParameters;
  PlaceParts parts;
  const AbsorptionLaw law(model.profile());
  for (int i = 0; i < kSampleCount; ++i) {
    const LayerPair absorption = law.at(i, parameters);
    parts.epidermis[i] = absorption.epidermal;
    parts.dermis[i] = absorption.dermal;
  }
  const Spectrum with = model.reflectance(parameters);
  // What the model leaves over is a factor, and stays.
  const Spectrum factor = place.edited / with.max(1e-9);
  for (const Parameter parameter : kConcentrations) {
    ParameterVector without = parameters;
    without[parameter] = 0.0;
    parts.contributions.emplace_back(parameter, factor * (model.reflectance(without) - with));
  }
  return parts;
}

}  // namespace cutis
