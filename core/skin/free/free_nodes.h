#pragma once  // internal to core/skin/free

// Spectral nodes as in core/skin/model/choose_nodes.h, that hold wherever the free constants may
// lie.

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/free_constants.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

// Chosen and checked on spectra all over the profile's parameter box, all oxygenations and all
// thicknesses that are free; the errors are over these. Deterministic. About 0.2 s; by radiative
// transfer 0.7 s more on one core where oxygenation is free, 4 s where thickness is. Errors: those
// of FreeSkin::make.
Result<SpectralNodes> chooseFreeNodes(const SkinModel& model, const SpectrumRows& rows,
                                      const FreeConstants& free, const NodeOptions& options,
                                      const JobContext& context);

}  // namespace cutis
