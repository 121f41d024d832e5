#include "core/skin/response_model.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "core/skin/free/free_response.h"
#include "core/skin/model/choose_nodes.h"
#include "core/skin/response_kernel.h"

namespace cutis {

ResponseModel::ResponseModel(const SkinModel& model, const SpectrumRows& rows,
                             const NodeOptions& options)
    : nodes_(chooseNodes(model, rows, options)), model_(std::in_place, model, nodes_.samples) {
  for (Eigen::Index n = 0; n < nodes_.weights.cols(); ++n) {
    for (Eigen::Index k = 0; k < nodes_.weights.rows(); ++k) {
      weights_.push_back(static_cast<float>(nodes_.weights(k, n)));
    }
  }
}

ResponseModel::ResponseModel(std::shared_ptr<const FreeResponse> free)
    : nodes_(free->nodes()), free_(free->free()), freeResponse_(std::move(free)) {}

Result<std::shared_ptr<const ResponseModel>> ResponseModel::create(const SkinModel& model,
                                                                   const SpectrumRows& rows,
                                                                   const FreeConstants& free,
                                                                   const JobContext& context,
                                                                   const NodeOptions& options) {
  CUTIS_CHECK(requireFive(model.profile(), "a picture"));
  if (free.count() == 0) return std::make_shared<const ResponseModel>(model, rows, options);
  CUTIS_TRY(response, FreeResponse::make(model, rows, free, options, context));
  return std::make_shared<const ResponseModel>(
      std::make_shared<const FreeResponse>(std::move(response)));
}

void ResponseModel::evaluate(PixelRows<const float> values, std::span<float* const> out) const {
  assert(out.size() == static_cast<std::size_t>(rowCount()));
  assert(values.rowCount == static_cast<std::size_t>(kParameterCount + free().count()));
  if (freeResponse_) return freeResponse_->evaluate(values, out);
  ResponseArguments arguments = {};
  arguments.nodes = model_->nodes<float>().data();
  arguments.nodeCount = model_->nodes<float>().size();
  arguments.layers = model_->layers<float>();
  arguments.parameters = values;
  arguments.weights = weights_.data();
  arguments.weightStride = out.size();
  // More rows than the kernel holds in registers are done in groups.
  for (std::size_t first = 0; first < out.size(); first += kMaximumResponseRows) {
    arguments.rowCount = std::min<std::size_t>(kMaximumResponseRows, out.size() - first);
    arguments.weights = weights_.data() + first;
    arguments.out = out.data() + first;
    runResponseKernel(arguments);
  }
}

}  // namespace cutis
