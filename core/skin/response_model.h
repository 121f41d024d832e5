#pragma once

// Rows of a response matrix times the reflectance of skin: camera channels, colour under a light, a
// UV or NIR band are all this one operation. The rows are reduced to spectral nodes once; a pixel
// then costs a dozen reflectances and a small product.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/pixel_rows.h"
#include "core/skin/model/compiled_model.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/free_constants.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

class FreeResponse;

// Thread-safe: const after construction.
class ResponseModel {
 public:
  // Chooses the nodes (about 0.1 s).
  ResponseModel(const SkinModel& model, const SpectrumRows& rows, const NodeOptions& options = {});
  // A model of pixels with constants of their own.
  explicit ResponseModel(std::shared_ptr<const FreeResponse> free);

  // Either: with constants of each pixel's own where some are free. Errors and cost: those of
  // FreeResponse::make, none where nothing is free.
  static Result<std::shared_ptr<const ResponseModel>> create(const SkinModel& model,
                                                             const SpectrumRows& rows,
                                                             const FreeConstants& free,
                                                             const JobContext& context,
                                                             const NodeOptions& options = {});

  int rowCount() const { return static_cast<int>(nodes_.weights.rows()); }
  const SpectralNodes& nodes() const { return nodes_; }
  // What a pixel must bring along.
  const FreeConstants& free() const { return free_; }

  // values: a row per parameter, then one per constant that is free, in the order of SkinConstant.
  // out[row][i] for each pixel of them. Within 2e-6 of SkinModel at the nodes, plus the nodes' own
  // error; the properties of reflectanceBatch() hold.
  void evaluate(PixelRows<const float> values, std::span<float* const> out) const;

 private:
  SpectralNodes nodes_;
  FreeConstants free_;
  std::shared_ptr<const FreeResponse> freeResponse_;  // null: the profile's constants
  std::optional<CompiledModel> model_;                // without `freeResponse_`
  std::vector<float> weights_;                        // by node, then row
};

}  // namespace cutis
