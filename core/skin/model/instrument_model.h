#pragma once

// The model as an instrument or a photograph sees it (core/skin/model/measurement_geometry.h), in
// double precision: for measured spectra, where the few that there are need no vectors.
//
// Thread-safe: const after construction. Parameters and absorptions are as in
// core/skin/model/skin_model.h.

#include <span>

#include "core/skin/model/measurement_geometry.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

class InstrumentModel {
 public:
  // The model outlives it. Precondition: validate(geometry) passed.
  InstrumentModel(const SkinModel& model, const MeasurementGeometry& geometry);

  const MeasurementGeometry& geometry() const { return geometry_; }

  // What is measured of two layers, and its derivatives with respect to their own absorptions.
  LayeredReflectance evaluate(int sample, double epidermalAbsorption,
                              double dermalAbsorption) const;

  double reflectanceAt(int sample, std::span<const double> parameters) const;
  double reflectanceAt(int sample, const ParameterVector& parameters) const {
    return reflectanceAt(sample, asSpan(parameters));
  }
  double reflectanceAt(int sample, std::span<const double> parameters, double* derivatives) const;
  double reflectanceAt(int sample, const ParameterVector& parameters,
                       ParameterVector& derivatives) const {
    return reflectanceAt(sample, asSpan(parameters), derivatives.data());
  }
  Spectrum reflectance(const ParameterVector& parameters) const;

 private:
  const SkinModel& model_;
  MeasurementGeometry geometry_;
  Spectrum dermalScattering_;
};

}  // namespace cutis
