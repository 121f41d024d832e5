#include "core/skin/free/free_response.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "core/skin/free/free_nodes.h"

namespace cutis {
namespace {

// Pixels evaluated at once: their reflectances stay in the cache.
constexpr std::size_t kRowsAtOnce = 64;
// The share of the progress after which the nodes are chosen; their tables follow.
constexpr double kNodesEnd = 0.8;

// Constants of pixel i, within their ranges.
SkinConstants constantsAt(PixelRows<const float> values, std::size_t i,
                          const FreeCoordinates& coordinates) {
  SkinConstants constants;
  for (const SkinConstant constant : kSkinConstants) {
    if (!coordinates.free().has(constant)) continue;
    const int row = kParameterCount + coordinates.indexOf(constant);
    constants[constant] = double{values.at(static_cast<std::size_t>(row), i)};
  }
  return coordinates.clamped(constants);
}

}  // namespace

Result<FreeResponse> FreeResponse::make(const SkinModel& model, const SpectrumRows& rows,
                                        const FreeConstants& free, const NodeOptions& options,
                                        const JobContext& context) {
  CUTIS_TRY(nodes, chooseFreeNodes(model, rows, free, options, context.child(0.0, kNodesEnd)));
  CUTIS_TRY(skin, FreeSkin::make(model, nodes.samples, free, context.child(kNodesEnd, 1.0)));
  return FreeResponse(std::move(nodes), std::move(skin));
}

void FreeResponse::evaluate(PixelRows<const float> values, std::span<float* const> out) const {
  assert(out.size() == static_cast<std::size_t>(rowCount()));
  std::vector<ParameterVector> parameters;
  std::vector<SkinConstants> constants;
  for (std::size_t begin = 0; begin < values.count; begin += kRowsAtOnce) {
    const std::size_t count = std::min(kRowsAtOnce, values.count - begin);
    parameters.resize(count);
    constants.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < kParameterCount; ++k) {
        parameters[i][static_cast<Eigen::Index>(k)] = double{values.at(k, begin + i)};
      }
      constants[i] = constantsAt(values, begin + i, skin_.coordinates());
    }
    const std::vector<double> reflectance =
        skin_.evaluate(parameters, constants, false).reflectance;
    for (std::size_t row = 0; row < out.size(); ++row) {
      for (std::size_t i = 0; i < count; ++i) {
        double sum = 0.0;
        for (std::size_t n = 0; n < nodes_.samples.size(); ++n) {
          sum += nodes_.weights(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(n)) *
                 reflectance[n * count + i];
        }
        out[row][begin + i] = static_cast<float>(sum);
      }
    }
  }
}

}  // namespace cutis
