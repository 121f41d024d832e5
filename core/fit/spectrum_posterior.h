#pragma once

// How far the spectrum of a pixel may lie from the estimate: one covariance of its parameters and
// of what the model leaves over, for bands in windows, regions and exports alike.
//
// Near the estimate the channels are linear in the coordinates of the parameters and in the
// coefficients of the discrepancy, and all of it is normal; parameters at the ends of their ranges
// count as free. The rest of the discrepancy adds to the spectrum's variance: itself, and what the
// fit, which knows nothing of it, makes of its share in the channels. Shading of an unknown amount
// adds to the channels' noise. Double precision, about 0.1 ms
// a pixel. Thread-safe: const after construction.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/fit/coordinate_prior.h"
#include "core/fit/fit_record.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

class SpectrumPosterior {
 public:
  // Takes a fit without free constants. The model outlives it. Precondition: the record is valid
  // with the model's profile.
  SpectrumPosterior(const SkinModel& model, const FitRecord& record);
  // As the fit was asked for.
  SpectrumPosterior(const SkinModel& model, const Rig& rig, const FitOptions& options)
      : SpectrumPosterior(model, fitRecord(model.profile(), rig, options)) {}

  // How many values a pixel has.
  std::size_t valueCount() const {
    return kParameterCount +
           static_cast<std::size_t>(discrepancy_ == nullptr ? 0 : discrepancy_->count());
  }

  // values: the five parameters, then the coefficients of the discrepancy where the fit estimates
  // one. channels: as measured, finite; or as modelled, where the measured ones are not at hand:
  // they only say how much noise there is.
  //
  // Covariance of the coordinates of the parameters (logarithms where the prior has them; nothing
  // for those that are held) and of the coefficients.
  Eigen::MatrixXd covariance(std::span<const double> channels,
                             std::span<const double> values) const;
  // Standard deviation of the reflectance at each sample.
  Spectrum deviation(std::span<const double> channels, std::span<const double> values) const {
    return deviations(channels, values).reflectance;
  }
  // That, and the deviations of the parameters as maps have them (core/fit/deviation_limit.h), 0
  // for those that are held.
  struct Deviations {
    ParameterVector parameters;
    Spectrum reflectance;
  };
  Deviations deviations(std::span<const double> channels, std::span<const double> values) const;
  // The reflectance itself, and what the channels are of it.
  Spectrum reflectance(std::span<const double> values) const;
  std::vector<double> channels(std::span<const double> values) const;

 private:
  struct Linearisation;
  struct Gain;
  Linearisation linearise(std::span<const double> values) const;
  Eigen::MatrixXd priorCovariance() const;
  Gain gainAt(const Linearisation& at, std::span<const double> channels) const;
  Eigen::ArrayXd restVariance(const Linearisation& at, const Gain& gain) const;

  const SkinModel& model_;
  SpectrumRows rows_;
  std::vector<Eigen::Index> seeing_;  // the channels that see something
  NoiseModel noise_;
  double shadingVariance_;
  CoordinatePrior coordinates_;
  const Discrepancy* discrepancy_;  // null: none
};

}  // namespace cutis
