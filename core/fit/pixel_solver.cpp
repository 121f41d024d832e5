#include "core/fit/pixel_solver.h"

#include <vector>

namespace cutis {

void PixelSolver::residuals(const PixelBatch& batch, float* residuals) const {
  ParameterBatch<float> parameters;
  parameters.count = batch.count;
  for (std::size_t k = 0; k < parameters.values.size(); ++k) {
    parameters.values[k] = batch.parameters + k * batch.stride;
  }
  std::vector<float*> rows;
  for (int k = 0; k < channelCount(); ++k) {
    rows.push_back(residuals + static_cast<std::size_t>(k) * batch.stride);
  }
  channels_->evaluate(parameters, rows);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const float* measured = batch.channels + k * batch.stride;
    for (std::size_t i = 0; i < batch.count; ++i) rows[k][i] = measured[i] - rows[k][i];
  }
}

}  // namespace cutis
