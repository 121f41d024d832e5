#pragma once

// Whole spectra of single skins, whose constants are their own where the profile's are free.
//
// Thread-safe: const after construction.

#include <memory>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/free/free_skin.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

class SkinSpectra {
 public:
  // For a profile without free constants, or with those that are free in maps: then it takes as
  // long as FreeSkin::make at all wavelengths, some seconds. Errors: those of FreeSkin::make, none
  // where nothing is free.
  static Result<SkinSpectra> make(std::shared_ptr<const SkinModel> model, const FreeConstants& free,
                                  const JobContext& context);

  // The constants count as far as they are free; out of range they are taken as the range's ends.
  // Without free constants exactly SkinModel::reflectance, else within the error of
  // core/skin/free/free_layers.h of the profile with these constants. About 0.1 ms.
  Spectrum reflectance(const ParameterVector& parameters, const SkinConstants& constants) const;

  const FreeConstants& free() const { return free_; }

 private:
  SkinSpectra(std::shared_ptr<const SkinModel> model, const FreeConstants& free)
      : model_(std::move(model)), free_(free) {}

  std::shared_ptr<const SkinModel> model_;
  FreeConstants free_;
  std::shared_ptr<const FreeSkin> skin_;  // null where nothing is free
};

}  // namespace cutis
