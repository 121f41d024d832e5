#include "core/skin/response_model.h"

#include <algorithm>
#include <array>
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

ResponseModel::ResponseModel(std::shared_ptr<const FreeResponse> variable)
    : nodes_(variable->nodes()), free_(variable->free()), variable_(std::move(variable)) {}

Result<std::shared_ptr<const ResponseModel>> ResponseModel::create(const SkinModel& model,
                                                                   const SpectrumRows& rows,
                                                                   const FreeConstants& free,
                                                                   const JobContext& context,
                                                                   const NodeOptions& options) {
  CUTIS_CHECK(requireFive(model.profile(), "a picture"));
  if (free.count() == 0) return std::make_shared<const ResponseModel>(model, rows, options);
  CUTIS_TRY(variable, FreeResponse::make(model, rows, free, options, context));
  return std::make_shared<const ResponseModel>(
      std::make_shared<const FreeResponse>(std::move(variable)));
}

void ResponseModel::evaluate(const ParameterBatch<float>& batch,
                             std::span<float* const> out) const {
  assert(out.size() == static_cast<std::size_t>(rowCount()));
  assert((batch.constants[kOxygenation] != nullptr) == free().oxygenation);
  assert((batch.constants[kThickness] != nullptr) == free().thickness);
  if (variable_) return variable_->evaluate(batch, out);
  ResponseArguments arguments = {};
  arguments.nodes = model_->nodes<float>().data();
  arguments.nodeCount = model_->nodes<float>().size();
  arguments.layers = model_->layers<float>();
  for (std::size_t k = 0; k < batch.values.size(); ++k)
    arguments.parameters[k] = batch.values[k];
  arguments.count = batch.count;
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
