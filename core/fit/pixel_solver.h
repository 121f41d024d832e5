#pragma once

// One interface for all methods: channels of a batch of pixels in, parameters out, and the
// constants of the profile that are free.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "core/fit/shading.h"
#include "core/skin/response_model.h"

namespace cutis {

// Pixels side by side: one row of `stride` floats per channel or value, of which the first `count`
// count. Values are the parameters and then, in the order of SkinConstant, the free constants.
struct PixelBatch {
  std::size_t count = 0;
  std::size_t stride = 0;
  const float* channels = nullptr;  // [channel][stride], finite and not negative
  float* parameters = nullptr;      // [value][stride], in the values' units
};

// What solving says about each pixel beside its parameters.
struct SolveReport {
  std::uint8_t* states = nullptr;       // PixelState, solved or noConvergence
  std::uint16_t* iterations = nullptr;  // 0 for a search
};

// Thread-safe: const after construction. A pixel's result is a function of its own channels alone,
// whatever stands beside it in the batch.
class PixelSolver {
 public:
  virtual ~PixelSolver() = default;

  // Writes batch.parameters.
  virtual void solve(const PixelBatch& batch, const SolveReport& report) const = 0;

  // Posterior standard deviations at batch.parameters, in the values' units: [value][stride].
  // Precondition: hasDeviations().
  virtual void deviations(const PixelBatch& batch, float* deviations) const = 0;
  virtual bool hasDeviations() const = 0;

  // Measured minus modelled, shading included, at batch.parameters: [channel][stride].
  void residuals(const PixelBatch& batch, float* residuals) const;

  // The factor on all channels at batch.parameters, one per pixel. Precondition: hasShading().
  void shading(const PixelBatch& batch, float* factors) const;
  bool hasShading() const { return shading_.has_value(); }

  // What the interface calls its work, e.g. "refined fit".
  virtual const char* stage() const = 0;
  // Wavelengths at which the model is evaluated for the channels.
  int nodeCount() const { return static_cast<int>(nodes().samples.size()); }
  const SpectralNodes& nodes() const { return channels_->nodes(); }
  int channelCount() const { return channels_->rowCount(); }
  FreeConstants free() const { return channels_->free(); }
  // Rows of PixelBatch::parameters.
  std::size_t valueCount() const {
    return static_cast<std::size_t>(kParameterCount + free().count());
  }

 protected:
  // channels: the rows of the rig.
  explicit PixelSolver(std::shared_ptr<const ResponseModel> channels,
                       const std::optional<ShadingModel>& shading = {})
      : channels_(std::move(channels)), shading_(shading) {}
  const ResponseModel& channelModel() const { return *channels_; }

 private:
  void evaluateChannels(const PixelBatch& batch, float* modelled) const;

  std::shared_ptr<const ResponseModel> channels_;
  std::optional<ShadingModel> shading_;
};

}  // namespace cutis
