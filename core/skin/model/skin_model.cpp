#include "core/skin/model/skin_model.h"

#include <cassert>
#include <utility>

#include "core/skin/layers/table.h"

namespace cutis {

SkinModel::SkinModel(const Profile& profile)
    : profile_(profile),
      epidermis_(epidermalAbsorption(profile)),
      dermis_(dermalAbsorption(profile)),
      optics_(makeDiffusionOptics(profile)) {
  assert(profile.layerOptics == LayerOpticsKind::diffusion);
}

SkinModel::SkinModel(const Profile& profile, std::shared_ptr<const LayerTable> table)
    : profile_(profile),
      epidermis_(epidermalAbsorption(profile)),
      dermis_(dermalAbsorption(profile)),
      optics_(makeTabulatedOptics(std::move(table))) {
  assert(profile.layerOptics == LayerOpticsKind::addingDoubling);
}

Result<std::shared_ptr<const SkinModel>> SkinModel::create(const Profile& profile,
                                                           const JobContext& context) {
  if (profile.layerOptics == LayerOpticsKind::diffusion) {
    return std::make_shared<const SkinModel>(profile);
  }
  CUTIS_TRY(table, LayerTable::makeWhole(profile, {}, context));
  return std::make_shared<const SkinModel>(profile,
                                           std::make_shared<const LayerTable>(std::move(table)));
}

double SkinModel::reflectanceAt(int sample, const ParameterVector& parameters) const {
  return optics_->reflectance(sample, epidermalAbsorptionAt(epidermis_, sample, parameters),
                              dermalAbsorptionAt(dermis_, sample, parameters));
}

Spectrum SkinModel::reflectance(const ParameterVector& parameters) const {
  Spectrum spectrum;
  for (int i = 0; i < kSampleCount; ++i)
    spectrum[i] = reflectanceAt(i, parameters);
  return spectrum;
}

double SkinModel::reflectanceAt(int sample, const ParameterVector& parameters,
                                ParameterVector& derivatives) const {
  const LayeredReflectance layered =
      optics_->evaluate(sample, epidermalAbsorptionAt(epidermis_, sample, parameters),
                        dermalAbsorptionAt(dermis_, sample, parameters));
  derivatives = parameterDerivatives(sample, parameters, layered);
  return layered.reflectance;
}

ParameterVector SkinModel::parameterDerivatives(int sample, const ParameterVector& parameters,
                                                const LayeredReflectance& layered) const {
  ParameterVector derivatives;
  const double eumelanin = epidermis_.eumelanin[sample];
  const double pheomelanin = epidermis_.pheomelanin[sample];
  const double blend = parameters[kMelaninBlend];
  const double perEpidermal = layered.perEpidermalAbsorption;
  derivatives[kMelanin] = perEpidermal * (blend * eumelanin + (1.0 - blend) * pheomelanin);
  derivatives[kMelaninBlend] = perEpidermal * parameters[kMelanin] * (eumelanin - pheomelanin);
  derivatives[kHaemoglobinDermal] = layered.perDermalAbsorption * dermis_.blood[sample];
  derivatives[kHaemoglobinEpidermal] = perEpidermal * epidermis_.blood[sample];
  derivatives[kCarotene] = perEpidermal * epidermis_.carotene[sample];
  return derivatives;
}

Spectrum SkinModel::reflectance(const ParameterVector& parameters,
                                SpectrumJacobian& derivatives) const {
  Spectrum spectrum;
  for (int i = 0; i < kSampleCount; ++i) {
    ParameterVector row;
    spectrum[i] = reflectanceAt(i, parameters, row);
    derivatives.row(i) = row.transpose();
  }
  return spectrum;
}

bool SkinModel::holdsAt(int sample, const ParameterVector& parameters) const {
  return optics_->holds(sample, epidermalAbsorptionAt(epidermis_, sample, parameters),
                        dermalAbsorptionAt(dermis_, sample, parameters));
}

}  // namespace cutis
