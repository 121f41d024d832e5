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

double InstrumentModel::reflectanceAt(int sample, std::span<const double> parameters) const {
  const LayerPair absorption = model_.absorption().at(sample, parameters);
  const EffectiveAbsorption effective =
      withEdgeLoss(geometry_, absorption.dermal, dermalScattering_[sample]);
  return measuredReflectance(
      geometry_, model_.optics().reflectance(sample, absorption.epidermal, effective.absorption));
}

double InstrumentModel::reflectanceAt(int sample, std::span<const double> parameters,
                                      double* derivatives) const {
  const LayerPair absorption = model_.absorption().at(sample, parameters);
  const LayeredReflectance layered = evaluate(sample, absorption.epidermal, absorption.dermal);
  model_.absorption().byParameters(sample, parameters,
                                   {layered.perEpidermalAbsorption, layered.perDermalAbsorption},
                                   derivatives);
  return layered.reflectance;
}

Spectrum InstrumentModel::reflectance(const ParameterVector& parameters) const {
  Spectrum spectrum;
  for (int i = 0; i < kSampleCount; ++i)
    spectrum[i] = reflectanceAt(i, parameters);
  return spectrum;
}

}  // namespace cutis
