#include "core/skin/model/skin_model.h"

#include <cassert>
#include <utility>

#include "core/skin/layers/table.h"

namespace cutis {

SkinModel::SkinModel(const Profile& profile)
    : profile_(profile), absorption_(profile), optics_(makeDiffusionOptics(profile)) {
  assert(profile.layerOptics == LayerOpticsKind::diffusion);
}

SkinModel::SkinModel(const Profile& profile, std::shared_ptr<const LayerTable> table)
    : profile_(profile), absorption_(profile), optics_(makeTabulatedOptics(std::move(table))) {
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

double SkinModel::reflectanceAt(int sample, std::span<const double> parameters) const {
  const LayerPair absorption = absorption_.at(sample, parameters);
  return optics_->reflectance(sample, absorption.epidermal, absorption.dermal);
}

Spectrum SkinModel::reflectance(std::span<const double> parameters) const {
  Spectrum spectrum;
  for (int i = 0; i < kSampleCount; ++i)
    spectrum[i] = reflectanceAt(i, parameters);
  return spectrum;
}

double SkinModel::reflectanceAt(int sample, std::span<const double> parameters,
                                double* derivatives) const {
  const LayerPair absorption = absorption_.at(sample, parameters);
  const LayeredReflectance layered =
      optics_->evaluate(sample, absorption.epidermal, absorption.dermal);
  absorption_.byParameters(sample, parameters,
                           {layered.perEpidermalAbsorption, layered.perDermalAbsorption},
                           derivatives);
  return layered.reflectance;
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

}  // namespace cutis
