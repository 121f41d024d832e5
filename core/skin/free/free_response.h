#pragma once

// A response model (core/skin/response_model.h) of skin whose constants differ from pixel to pixel:
// rows of a response matrix times the reflectance of each, in double precision at spectral nodes.

#include <span>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/pixel_rows.h"
#include "core/base/result.h"
#include "core/skin/free/free_skin.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

// Thread-safe: const after construction.
class FreeResponse {
 public:
  // Chooses the nodes; cost and errors: those of chooseFreeNodes().
  static Result<FreeResponse> make(const SkinModel& model, const SpectrumRows& rows,
                                   const FreeConstants& free, const NodeOptions& options,
                                   const JobContext& context);

  int rowCount() const { return static_cast<int>(nodes_.weights.rows()); }
  const SpectralNodes& nodes() const { return nodes_; }
  const FreeSkin& skin() const { return skin_; }
  const FreeConstants& free() const { return skin_.coordinates().free(); }

  // values and out: as for ResponseModel::evaluate().
  // Constants out of range are taken as the range's ends. Within the nodes' own error, and that of
  // core/skin/free/free_layers.h; a pixel's result is its own, NaN stays in its pixel. About 1 µs
  // per pixel and core by radiative transfer, 4 µs with the thickness free.
  void evaluate(PixelRows<const float> values, std::span<float* const> out) const;

 private:
  FreeResponse(SpectralNodes nodes, FreeSkin skin)
      : nodes_(std::move(nodes)), skin_(std::move(skin)) {}

  SpectralNodes nodes_;
  FreeSkin skin_;
};

}  // namespace cutis
