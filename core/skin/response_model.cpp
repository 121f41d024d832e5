#include "core/skin/response_model.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "core/skin/free/free_response.h"
#include "core/skin/model/choose_nodes.h"
#include "core/skin/response_kernel.h"

namespace cutis {

namespace {

// The rows as the expected skin is seen, and behind them what each coefficient adds.
SpectrumRows rowsWith(const Discrepancy* discrepancy, const SpectrumRows& rows) {
  if (discrepancy == nullptr) return rows;
  const Eigen::Index count = rows.rows();
  SpectrumRows all(count * (1 + discrepancy->count()), int{kSampleCount});
  for (Eigen::Index k = 0; k < count; ++k) {
    all.row(k) = rows.row(k) * (1.0 + discrepancy->mean).transpose();
    for (int c = 0; c < discrepancy->count(); ++c) {
      all.row((c + 1) * count + k) =
          rows.row(k) * discrepancy->components.col(c).transpose().array();
    }
  }
  return all;
}

}  // namespace

ResponseModel::ResponseModel(const SkinModel& model, const SpectrumRows& rows,
                             const NodeOptions& options, const Discrepancy* discrepancy)
    : rowCount_(static_cast<int>(rows.rows())),
      coefficientCount_(discrepancy == nullptr ? 0 : discrepancy->count()),
      nodes_(chooseNodes(model, rowsWith(discrepancy, rows), options)),
      model_(std::in_place, model, nodes_.samples) {
  for (Eigen::Index n = 0; n < nodes_.weights.cols(); ++n) {
    for (Eigen::Index k = 0; k < nodes_.weights.rows(); ++k) {
      weights_.push_back(static_cast<float>(nodes_.weights(k, n)));
    }
  }
}

ResponseModel::ResponseModel(std::shared_ptr<const FreeResponse> free)
    : rowCount_(free->rowCount()),
      nodes_(free->nodes()),
      free_(free->free()),
      freeResponse_(std::move(free)) {}

Result<std::shared_ptr<const ResponseModel>> ResponseModel::create(const SkinModel& model,
                                                                   const SpectrumRows& rows,
                                                                   const PerPixel& perPixel,
                                                                   const JobContext& context,
                                                                   const NodeOptions& options) {
  CUTIS_CHECK(requireFive(model.profile(), "a picture"));
  if (perPixel.free.count() == 0) {
    return std::make_shared<const ResponseModel>(model, rows, options,
                                                 discrepancyOf(model.profile(), perPixel));
  }
  CUTIS_TRY(response, FreeResponse::make(model, rows, perPixel.free, options, context));
  return std::make_shared<const ResponseModel>(
      std::make_shared<const FreeResponse>(std::move(response)));
}

void ResponseModel::evaluate(PixelRows<const float> values, std::span<float* const> out) const {
  assert(out.size() == static_cast<std::size_t>(rowCount()));
  assert(values.rowCount ==
         static_cast<std::size_t>(kParameterCount + free().count() + coefficientCount_));
  if (freeResponse_) return freeResponse_->evaluate(values, out);
  ResponseArguments arguments = {};
  arguments.nodes = model_->nodes<float>().data();
  arguments.nodeCount = model_->nodes<float>().size();
  arguments.layers = model_->layers<float>();
  arguments.parameters = values;
  arguments.coefficients = {values.row(kParameterCount),
                            static_cast<std::size_t>(coefficientCount_), values.count,
                            values.stride};
  arguments.weightStride = static_cast<std::size_t>(nodes_.weights.rows());
  arguments.coefficientStride = out.size();
  // More rows than the kernel holds in registers are done in groups.
  for (std::size_t first = 0; first < out.size(); first += kMaximumResponseRows) {
    arguments.rowCount = std::min<std::size_t>(kMaximumResponseRows, out.size() - first);
    arguments.weights = weights_.data() + first;
    arguments.out = out.data() + first;
    runResponseKernel(arguments);
  }
}

}  // namespace cutis
