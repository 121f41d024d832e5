#pragma once

// One interface for all methods: channels of pixels in, parameters out, and the constants of the
// profile that are free.
//
// Channels: a row per channel of the rig, finite and not negative. Values: a row per parameter and
// then, in the order of SkinConstant, one per free constant, in the values' units, and one per
// coefficient of a discrepancy; as many pixels as there are of channels.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/pixel_rows.h"
#include "core/fit/shading.h"
#include "core/skin/pixel_state.h"
#include "core/skin/response_model.h"

namespace cutis {

// What solving says about each pixel beside its values.
struct SolveReport {
  PixelState* states = nullptr;         // solved or noConvergence
  std::uint16_t* iterations = nullptr;  // 0 for a search
};

// Thread-safe: const after construction. A pixel's result is a function of its own channels alone,
// whatever stands beside it.
class PixelSolver {
 public:
  virtual ~PixelSolver() = default;

  // Writes the values.
  virtual void solve(PixelRows<const float> channels, PixelRows<float> values,
                     const SolveReport& report) const = 0;

  // Posterior standard deviations at the values, laid out like them, of all but coefficients, whose
  // rows are left as they are. Precondition: hasDeviations().
  virtual void deviations(PixelRows<const float> channels, PixelRows<const float> values,
                          PixelRows<float> deviations) const = 0;
  virtual bool hasDeviations() const = 0;

  // Measured minus modelled, shading included, at the values: laid out like the channels.
  void residuals(PixelRows<const float> channels, PixelRows<const float> values,
                 PixelRows<float> residuals) const;

  // The factor on all channels at the values, one per pixel. Precondition: the fit
  // estimates it.
  void shading(PixelRows<const float> channels, PixelRows<const float> values,
               float* factors) const;

  // What the interface calls its work, e.g. "refined fit".
  virtual const char* stage() const = 0;
  // Wavelengths at which the model is evaluated for the channels.
  int nodeCount() const { return static_cast<int>(nodes().samples.size()); }
  const SpectralNodes& nodes() const { return channels_->nodes(); }
  int channelCount() const { return channels_->rowCount(); }
  FreeConstants free() const { return channels_->free(); }
  // How many coefficients of a discrepancy are found for each pixel.
  int coefficientCount() const { return channels_->coefficientCount(); }
  // Rows of the values.
  std::size_t valueCount() const {
    return static_cast<std::size_t>(kParameterCount + free().count() + coefficientCount());
  }

 protected:
  // channels: the rows of the rig.
  explicit PixelSolver(std::shared_ptr<const ResponseModel> channels,
                       const std::optional<ShadingModel>& shading = {})
      : channels_(std::move(channels)), shading_(shading) {}
  const ResponseModel& channelModel() const { return *channels_; }

 private:
  void evaluateChannels(PixelRows<const float> values, PixelRows<float> modelled) const;

  std::shared_ptr<const ResponseModel> channels_;
  std::optional<ShadingModel> shading_;
};

}  // namespace cutis
