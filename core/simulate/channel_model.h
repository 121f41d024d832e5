#pragma once  // internal to core/simulate

// A rig's photographs of skin, many pixels at once: like a ResponseModel of the rig's rows, but
// chosen from fewer spectra and with every channel from one evaluation of the nodes, because a
// simulation is asked for once and at once.

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/pixel_rows.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/skin/model/compiled_model.h"
#include "core/skin/model/reflectance_batch.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/response_model.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

// Thread-safe: const after construction.
class ChannelModel {
 public:
  // Channels within about 1e-6 rms over the profile's whole range, 2e-5 at worst. About 50 ms for
  // nine channels.
  // Where pixels bring more along than the parameters, cost and errors are those of
  // ResponseModel::create().
  static Result<ChannelModel> create(const SkinModel& model, const Rig& rig,
                                     const PerPixel& perPixel, const JobContext& context);

  std::size_t channelCount() const { return weights_.size(); }

  // values: as for ResponseModel::evaluate(). channels: a row each, of as many pixels;
  // `reflectance` is working memory.
  void evaluate(PixelRows<const float> values, std::vector<float>& reflectance,
                PixelRows<float> channels) const;

 private:
  ChannelModel(const SkinModel& model, const SpectralNodes& nodes, int channelCount);

  CompiledModel nodes_;
  std::vector<std::vector<float>> weights_;        // by channel, then node
  std::shared_ptr<const ResponseModel> response_;  // instead of both, where pixels bring more along
};

}  // namespace cutis
