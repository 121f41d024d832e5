#pragma once

// Whole spectra of single skins, whose constants are their own where the profile's are free.
//
// Thread-safe: const after construction.

#include <memory>
#include <span>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/free/free_skin.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

class SkinSpectra {
 public:
  // For a profile without free constants, or with what maps bring along: with constants it takes as
  // long as FreeSkin::make at all wavelengths, some seconds. Errors: those of FreeSkin::make, none
  // where nothing is free.
  static Result<SkinSpectra> make(std::shared_ptr<const SkinModel> model, const PerPixel& perPixel,
                                  const JobContext& context);

  // The constants count as far as they are free; out of range they are taken as the range's ends.
  // Without free constants exactly SkinModel::reflectance, else within the error of
  // core/skin/free/free_layers.h of the profile with these constants. About 0.1 ms.
  // coefficients: of the discrepancy, as many as the maps bring along.
  Spectrum reflectance(const ParameterVector& parameters, const SkinConstants& constants,
                       std::span<const double> coefficients = {}) const;

  const FreeConstants& free() const { return perPixel_.free; }

 private:
  SkinSpectra(std::shared_ptr<const SkinModel> model, const PerPixel& perPixel)
      : model_(std::move(model)), perPixel_(perPixel) {}

  std::shared_ptr<const SkinModel> model_;
  PerPixel perPixel_;
  std::shared_ptr<const FreeSkin> skin_;  // null where nothing is free
};

}  // namespace cutis
