#pragma once

// The skin model at some wavelengths for many skins at once, each with constants of its own in
// place of the profile's, in double precision with all derivatives.
//
// Thread-safe: const after construction. A skin's values are its own, whatever the others are.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/free/free_absorption.h"
#include "core/skin/free/free_coordinates.h"
#include "core/skin/free/free_layers.h"
#include "core/skin/model/measurement_geometry.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

struct FreeSkinOptions {
  double edgeLossPerMm = 0.0;  // of the measurement (core/skin/model/measurement_geometry.h)
  int thicknessPoints = kThicknessPoints;  // as in FreeLayers::make
};

// [sample][skin]. The derivatives are there only where they were asked for.
struct FreeSpectra {
  std::vector<double> reflectance;
  std::vector<double> perEpidermal, perDermal;  // by the layers' own absorptions, mm
  std::vector<double> perOxygenation;
  std::vector<double> perThickness;  // mm⁻¹
  // Absorption per volume fraction of blood, net of displaced tissue, mm⁻¹.
  std::vector<double> epidermalBlood, dermalBlood;
};

class FreeSkin {
 public:
  // samples: positions on the wavelength grid. Cost and errors: those of FreeLayers::make; and a
  // profile with further chromophores is refused.
  static Result<FreeSkin> make(const SkinModel& model, std::span<const int> samples,
                               const FreeConstants& free, const JobContext& context,
                               const FreeSkinOptions& options = {});

  const std::vector<int>& samples() const { return samples_; }
  const FreeCoordinates& coordinates() const { return coordinates_; }
  const ParameterAxes& axes() const { return axes_; }
  // Its blood is the profile's, not that of a skin.
  const AbsorptionLaw& absorption() const { return absorption_.law(); }

  // One set of constants a skin, in their ranges; what is not free is the profile's, whatever is
  // asked for. Parameters within the profile's ranges.
  FreeSpectra evaluate(std::span<const ParameterVector> parameters,
                       std::span<const SkinConstants> constants, bool derivatives) const;

  // ∂R by the five parameters at the sample in place `s` of samples(), of skin i out of `count`
  // that have these parameters. Precondition: the spectra have derivatives.
  void byParameters(const FreeSpectra& spectra, std::size_t s, std::size_t i, std::size_t count,
                    const ParameterVector& parameters, ParameterVector& derivatives) const;

 private:
  FreeSkin(const SkinModel& model, std::span<const int> samples, FreeCoordinates coordinates,
           FreeLayers layers, double edgeLossPerMm);

  std::vector<int> samples_;
  FreeCoordinates coordinates_;
  ParameterAxes axes_;
  FreeAbsorption absorption_;
  Spectrum dermalScattering_;
  MeasurementGeometry edge_;  // its edge loss alone
  FreeLayers layers_;
};

}  // namespace cutis
