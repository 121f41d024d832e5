#include "core/skin/model/instrument_model.h"

namespace cutis {

InstrumentModel::InstrumentModel(const SkinModel& model, const MeasurementGeometry& geometry)
    : model_(model), geometry_(geometry), dermalScattering_(dermalScattering(model.profile())) {}

LayeredReflectance InstrumentModel::evaluate(int sample, double epidermalAbsorption,
                                             double dermalAbsorption) const {
  const EffectiveAbsorption effective =
      withEdgeLoss(geometry_, dermalAbsorption, dermalScattering_[sample]);
  LayeredReflectance layered =
      model_.optics().evaluate(sample, epidermalAbsorption, effective.absorption);
  layered.reflectance = measuredReflectance(geometry_, layered.reflectance);
  layered.perEpidermalAbsorption *= geometry_.enteringShare;
  layered.perDermalAbsorption *= geometry_.enteringShare * effective.slope;
  return layered;
}

double InstrumentModel::reflectanceAt(int sample, const ParameterVector& parameters) const {
  const EffectiveAbsorption effective =
      withEdgeLoss(geometry_, dermalAbsorptionAt(model_.dermis(), sample, parameters),
                   dermalScattering_[sample]);
  return measuredReflectance(
      geometry_, model_.optics().reflectance(
                     sample, epidermalAbsorptionAt(model_.epidermis(), sample, parameters),
                     effective.absorption));
}

double InstrumentModel::reflectanceAt(int sample, const ParameterVector& parameters,
                                      ParameterVector& derivatives) const {
  const LayeredReflectance layered =
      evaluate(sample, epidermalAbsorptionAt(model_.epidermis(), sample, parameters),
               dermalAbsorptionAt(model_.dermis(), sample, parameters));
  derivatives = model_.parameterDerivatives(sample, parameters, layered);
  return layered.reflectance;
}

Spectrum InstrumentModel::reflectance(const ParameterVector& parameters) const {
  Spectrum spectrum;
  for (int i = 0; i < kSampleCount; ++i)
    spectrum[i] = reflectanceAt(i, parameters);
  return spectrum;
}

}  // namespace cutis
