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
#include "core/skin/profile/per_pixel.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

class FreeResponse;

// Thread-safe: const after construction.
class ResponseModel {
 public:
  // Chooses the nodes (about 0.1 s). With a discrepancy, pixels bring its coefficients along.
  ResponseModel(const SkinModel& model, const SpectrumRows& rows, const NodeOptions& options = {},
                const Discrepancy* discrepancy = nullptr);
  // The response of pixels with constants of their own.
  explicit ResponseModel(std::shared_ptr<const FreeResponse> free);

  // For pixels that bring this along. Errors and cost: those of FreeResponse::make, none where no
  // constant is free.
  static Result<std::shared_ptr<const ResponseModel>> create(const SkinModel& model,
                                                             const SpectrumRows& rows,
                                                             const PerPixel& perPixel,
                                                             const JobContext& context,
                                                             const NodeOptions& options = {});

  int rowCount() const { return rowCount_; }
  // Weights of the rows and, with a discrepancy, of what each coefficient adds to them.
  const SpectralNodes& nodes() const { return nodes_; }
  // How many coefficients of a discrepancy a pixel must bring along.
  int coefficientCount() const { return coefficientCount_; }
  // What a pixel must bring along.
  const FreeConstants& free() const { return free_; }

  // values: a row per parameter, then one per constant that is free, in the order of SkinConstant,
  // then one per coefficient.
  // out[row][i] for each pixel of them. Within 2e-6 of SkinModel at the nodes, plus the nodes' own
  // error; the properties of reflectanceBatch() hold.
  void evaluate(PixelRows<const float> values, std::span<float* const> out) const;

 private:
  int rowCount_ = 0;
  int coefficientCount_ = 0;
  SpectralNodes nodes_;
  FreeConstants free_;
  std::shared_ptr<const FreeResponse> freeResponse_;  // null: the profile's constants
  std::optional<CompiledModel> model_;                // without `freeResponse_`
  std::vector<float> weights_;                        // by node, then weight
};

}  // namespace cutis
