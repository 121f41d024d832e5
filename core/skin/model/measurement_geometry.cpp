#include "core/skin/model/measurement_geometry.h"

#include <algorithm>
#include <cmath>

#include "core/transport/fresnel.h"

namespace cutis {
namespace {

constexpr double kFirstBesselZero = 2.404825557695773;

}  // namespace

MeasurementGeometry measurementGeometry(SpecularPart part, double refractiveIndex, double share) {
  MeasurementGeometry geometry;
  geometry.specularShare = part == SpecularPart::included ? share : 0.0;
  geometry.enteringShare = 1.0 - normalReflectance(refractiveIndex);
  return geometry;
}

double edgeLossOfAperture(double radiusMm) {
  return kFirstBesselZero / radiusMm;
}

Status validate(const MeasurementGeometry& geometry, const std::string& place) {
  if (!(geometry.specularShare >= 0.0 && geometry.specularShare < 1.0)) {
    return inputError(place, "the specular share must be at least 0 and below 1");
  }
  if (!(geometry.enteringShare > 0.0 && geometry.enteringShare <= 1.0)) {
    return inputError(place, "the share of light that enters must be above 0 and at most 1");
  }
  if (!(geometry.edgeLossPerMm >= 0.0 && std::isfinite(geometry.edgeLossPerMm))) {
    return inputError(place, "the edge loss must be finite and not negative");
  }
  return {};
}

double measuredReflectance(const MeasurementGeometry& geometry, double reflectance) {
  return geometry.specularShare + geometry.enteringShare * reflectance;
}

double modelReflectance(const MeasurementGeometry& geometry, double measured) {
  return (measured - geometry.specularShare) / geometry.enteringShare;
}

std::vector<double> modelReflectances(const MeasurementGeometry& geometry,
                                      std::span<const double> measured) {
  std::vector<double> modelled(measured.size());
  std::transform(measured.begin(), measured.end(), modelled.begin(),
                 [&](double value) { return modelReflectance(geometry, value); });
  return modelled;
}

EffectiveAbsorption withEdgeLoss(const MeasurementGeometry& geometry, double dermalAbsorption,
                                 double dermalScattering) {
  const double k = geometry.edgeLossPerMm;
  if (k == 0.0) return {dermalAbsorption, 1.0};
  const double extinction = dermalScattering + dermalAbsorption;
  const double loss = k * k / (3.0 * extinction);
  return {dermalAbsorption + loss, 1.0 - loss / extinction};
}

}  // namespace cutis
