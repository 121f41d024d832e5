#pragma once

// The model of a profile, in double precision: five parameters to a reflectance spectrum. The
// reference that every faster path is held against.
//
// Thread-safe: const after construction. Parameters outside the profile's ranges are evaluated as
// they are; the result is meaningful as long as no absorption turns negative.

#include <memory>

#include <Eigen/Core>

#include "core/skin/absorption.h"
#include "core/skin/layer_optics.h"
#include "core/skin/parameter_axis.h"
#include "core/skin/profile.h"
#include "core/spectra/grid.h"

namespace cutis {

// ∂R(λ)/∂(parameter), one column per parameter.
using SpectrumJacobian = Eigen::Array<double, kSampleCount, kParameterCount>;

class SkinModel {
 public:
  // Precondition: validate(profile) passed.
  explicit SkinModel(const Profile& profile);

  const Profile& profile() const { return profile_; }
  const EpidermalAbsorption& epidermis() const { return epidermis_; }
  const DermalAbsorption& dermis() const { return dermis_; }
  const LayerOptics& optics() const { return *optics_; }

  double reflectanceAt(int sample, const ParameterVector& parameters) const;
  Spectrum reflectance(const ParameterVector& parameters) const;

  // Reflectance at one sample and its five derivatives.
  double reflectanceAt(int sample, const ParameterVector& parameters,
                       ParameterVector& derivatives) const;
  Spectrum reflectance(const ParameterVector& parameters, SpectrumJacobian& derivatives) const;

  // Whether the layer optics hold at this sample.
  bool holdsAt(int sample, const ParameterVector& parameters) const;

 private:
  Profile profile_;
  EpidermalAbsorption epidermis_;
  DermalAbsorption dermis_;
  std::unique_ptr<const LayerOptics> optics_;
};

}  // namespace cutis
