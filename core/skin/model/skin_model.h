#pragma once

// The model of a profile, in double precision: parameters to a reflectance spectrum. The reference
// that every faster path is held against.
//
// Parameters are five, or as many as the profile has (parameterCount()); without the amounts of its
// further chromophores these are 0. Outside the profile's ranges they are evaluated as they are;
// the result is meaningful as long as no absorption turns negative. Thread-safe: const after
// construction.

#include <memory>
#include <span>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/layers/optics.h"
#include "core/skin/model/node_cache.h"
#include "core/skin/profile/absorption.h"
#include "core/skin/profile/parameter_axis.h"
#include "core/skin/profile/profile.h"
#include "core/spectra/grid.h"

namespace cutis {

// ∂R(λ)/∂(parameter), one column per parameter.
using SpectrumJacobian = Eigen::Array<double, kSampleCount, kParameterCount>;

class SkinModel {
 public:
  // The model of a profile whose layers are by diffusion. Precondition: validate(profile) passed.
  explicit SkinModel(const Profile& profile);
  // The model of one by radiative transfer. Precondition: validate(profile) passed; the table is
  // the profile's, at all wavelengths.
  SkinModel(const Profile& profile, std::shared_ptr<const LayerTable> table);

  // Either, making the table where one is needed: then about 2 s on one core. Cancelled if asked to
  // stop. Errors: those of LayerTable::make. Precondition: validate(profile) passed.
  static Result<std::shared_ptr<const SkinModel>> create(const Profile& profile,
                                                         const JobContext& context = {});

  const Profile& profile() const { return profile_; }
  const AbsorptionLaw& absorption() const { return absorption_; }
  const LayerOptics& optics() const { return *optics_; }
  // Where chooseNodes() keeps its choices.
  NodeCache& nodeCache() const { return *nodeCache_; }

  double reflectanceAt(int sample, std::span<const double> parameters) const;
  double reflectanceAt(int sample, const ParameterVector& parameters) const {
    return reflectanceAt(sample, asSpan(parameters));
  }
  Spectrum reflectance(std::span<const double> parameters) const;
  Spectrum reflectance(const ParameterVector& parameters) const {
    return reflectance(asSpan(parameters));
  }

  // Reflectance at one sample and its derivatives, as many as there are parameters.
  double reflectanceAt(int sample, std::span<const double> parameters, double* derivatives) const;
  double reflectanceAt(int sample, const ParameterVector& parameters,
                       ParameterVector& derivatives) const {
    return reflectanceAt(sample, asSpan(parameters), derivatives.data());
  }
  Spectrum reflectance(const ParameterVector& parameters, SpectrumJacobian& derivatives) const;

 private:
  Profile profile_;
  AbsorptionLaw absorption_;
  std::unique_ptr<const LayerOptics> optics_;
  std::unique_ptr<NodeCache> nodeCache_ = std::make_unique<NodeCache>();
};

}  // namespace cutis
