#include "core/fit/pixel_solver.h"

#include <vector>

namespace cutis {

void PixelSolver::evaluateChannels(const PixelBatch& batch, float* modelled) const {
  ParameterBatch<float> parameters;
  parameters.count = batch.count;
  for (std::size_t k = 0; k < parameters.values.size(); ++k) {
    parameters.values[k] = batch.parameters + k * batch.stride;
  }
  std::size_t next = parameters.values.size();
  for (const SkinConstant constant : kSkinConstants) {
    if (free().has(constant)) {
      parameters.constants[constant] = batch.parameters + next++ * batch.stride;
    }
  }
  std::vector<float*> rows;
  for (int k = 0; k < channelCount(); ++k) {
    rows.push_back(modelled + static_cast<std::size_t>(k) * batch.stride);
  }
  channels_->evaluate(parameters, rows);
}

void PixelSolver::residuals(const PixelBatch& batch, float* residuals) const {
  evaluateChannels(batch, residuals);
  for (std::size_t i = 0; i < batch.count; ++i) {
    const float factor = shading_ ? shadingFactor(*shading_, batch.channels + i, residuals + i,
                                                  channelCount(), batch.stride)
                                  : 1.0f;
    for (std::size_t k = 0; k < static_cast<std::size_t>(channelCount()); ++k) {
      float& value = residuals[k * batch.stride + i];
      value = batch.channels[k * batch.stride + i] - factor * value;
    }
  }
}

void PixelSolver::shading(const PixelBatch& batch, float* factors) const {
  std::vector<float> modelled(static_cast<std::size_t>(channelCount()) * batch.stride);
  evaluateChannels(batch, modelled.data());
  for (std::size_t i = 0; i < batch.count; ++i) {
    factors[i] = shadingFactor(*shading_, batch.channels + i, modelled.data() + i, channelCount(),
                               batch.stride);
  }
}

}  // namespace cutis
