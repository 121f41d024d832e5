#include "core/calibrate/discrepancy_study.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/base/number_text.h"
#include "core/calibrate/discrepancy_learning.h"
#include "core/skin/model/measurement_geometry.h"
#include "core/skin/model/skin_model.h"

namespace cutis {
namespace {

// The learned prior is known to no more digits.
constexpr int kLearnedPriorDigits = 4;
// Where a darker skin's ultraviolet is all but the surface's reflection, what is left after taking
// that off is error, and may be negative.
constexpr double kLeastRemoved = 0.003;

MeasurementGeometry geometryOf(const DiscrepancyStudy& study, SpecularPart part) {
  return measurementGeometry(part, study.profile.refractiveIndex, study.spectra.specularShare);
}

// As if measured with the surface's reflection or without it.
SpectraSet asSeen(const DiscrepancyStudy& study, SurfaceLight surface) {
  const MeasuredSpectra& spectra = study.spectra.spectra;
  const MeasurementGeometry own = geometryOf(study, study.spectra.specular);
  const MeasurementGeometry other = geometryOf(study, SpecularPart::included);
  const bool asMeasured =
      surface == SurfaceLight::included && study.spectra.specular == SpecularPart::included;
  SpectraSet set;
  for (int sample = 0; sample < kSampleCount; ++sample) {
    const double wavelength = wavelengthNm(sample);
    if (wavelength < spectra.wavelengthsNm.front() || wavelength > spectra.wavelengthsNm.back())
      continue;
    set.samples.push_back(sample);
  }
  set.measured.resize(static_cast<Eigen::Index>(set.samples.size()),
                      static_cast<Eigen::Index>(spectra.ids.size()));
  for (std::size_t i = 0; i < spectra.ids.size(); ++i) {
    Spectrum spectrum = onGrid(spectra, i);
    for (double& value : spectrum) {
      if (asMeasured || !(value > 0.0)) continue;
      value = std::max(modelReflectance(own, value), kLeastRemoved);
      if (surface == SurfaceLight::included) value = measuredReflectance(other, value);
    }
    set.measured.col(static_cast<Eigen::Index>(i)) = spectrum(set.samples);
  }
  return set;
}

Result<Discrepancy> learnedFrom(const SkinModel& model, const DiscrepancyStudy& study,
                                const SpectraSet& set, const JobContext& context) {
  DiscrepancyLearning options;
  options.components = study.components;
  options.prior = study.profile.prior;
  options.edgeLossPerMm = study.spectra.edgeLossPerMm;
  CUTIS_TRY(discrepancy, learnDiscrepancy(model, set, options, context));
  for (int k = 0; k < kParameterCount; ++k) {
    discrepancy.prior.mean[k] = roundedTo(discrepancy.prior.mean[k], kLearnedPriorDigits);
    discrepancy.prior.deviation[k] = roundedTo(discrepancy.prior.deviation[k], kLearnedPriorDigits);
  }
  return discrepancy;
}

}  // namespace

Result<Discrepancies> learnDiscrepancies(const DiscrepancyStudy& study, const JobContext& context) {
  CUTIS_TRY(model, SkinModel::create(study.profile, {context.stop, {}, {}}));
  const SpectraSet included = asSeen(study, SurfaceLight::included);
  CUTIS_TRY(asMeasured, learnedFrom(*model, study, included, context.child(0.0, 0.5)));
  const SpectraSet removed = asSeen(study, SurfaceLight::removed);
  CUTIS_TRY(belowSurface, learnedFrom(*model, study, removed, context.child(0.5, 1.0)));
  return Discrepancies{asMeasured, belowSurface};
}

}  // namespace cutis
