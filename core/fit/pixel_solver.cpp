#include "core/fit/pixel_solver.h"

#include <vector>

namespace cutis {

void PixelSolver::evaluateChannels(PixelRows<const float> values, PixelRows<float> modelled) const {
  std::vector<float*> rows;
  for (std::size_t k = 0; k < modelled.rowCount; ++k)
    rows.push_back(modelled.row(k));
  channels_->evaluate(values, rows);
}

void PixelSolver::residuals(PixelRows<const float> channels, PixelRows<const float> values,
                            PixelRows<float> residuals) const {
  evaluateChannels(values, residuals);
  for (std::size_t i = 0; i < channels.count; ++i) {
    const float factor =
        shading_ ? shadingFactor(*shading_, channels.part(i, 1), residuals.part(i, 1)) : 1.0f;
    for (std::size_t k = 0; k < residuals.rowCount; ++k) {
      float& value = residuals.at(k, i);
      value = channels.at(k, i) - factor * value;
    }
  }
}

void PixelSolver::shading(PixelRows<const float> channels, PixelRows<const float> values,
                          float* factors) const {
  PixelBuffer<float> modelled(channels.rowCount, channels.count);
  evaluateChannels(values, modelled.rows());
  for (std::size_t i = 0; i < channels.count; ++i) {
    factors[i] = shadingFactor(*shading_, channels.part(i, 1), modelled.rows().part(i, 1));
  }
}

}  // namespace cutis
