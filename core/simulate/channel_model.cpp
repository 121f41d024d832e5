#include "core/simulate/channel_model.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "core/skin/profile/parameter_sampling.h"

namespace cutis {
namespace {

constexpr int kTrainingCount = 400;
constexpr int kCheckingCount = 200;
constexpr NodeOptions kNodeOptions = {1e-6, 40};

Result<SpectrumRows> sampledSpectra(const SkinModel& model, int count, int first,
                                    const JobContext& context) {
  const std::vector<ParameterVector> points = sampleBox(model.profile().axes, count, first);
  SpectrumRows spectra(count, kSampleCount);
  CUTIS_CHECK(parallelFor(points.size(), context, [&](std::size_t i) -> Status {
    spectra.row(static_cast<Eigen::Index>(i)) = model.reflectance(points[i]).transpose();
    return {};
  }));
  return spectra;
}

}  // namespace

Result<ChannelModel> ChannelModel::create(const SkinModel& model, const Rig& rig,
                                          const PerPixel& perPixel, const JobContext& context) {
  if (perPixel != PerPixel{}) {
    CUTIS_TRY(response,
              ResponseModel::create(model, responseRows(rig), perPixel, context, kNodeOptions));
    ChannelModel channels(model, {}, rig.channelCount());
    channels.response_ = std::move(response);
    return channels;
  }
  CUTIS_TRY(training, sampledSpectra(model, kTrainingCount, 0, context.child(0.0, 0.3)));
  CUTIS_TRY(checking,
            sampledSpectra(model, kCheckingCount, kTrainingCount, context.child(0.3, 0.5)));
  return ChannelModel(model,
                      chooseSpectralNodes(responseRows(rig), training, checking, kNodeOptions),
                      rig.channelCount());
}

ChannelModel::ChannelModel(const SkinModel& model, const SpectralNodes& nodes, int channelCount)
    : nodes_(model, nodes.samples), weights_(static_cast<std::size_t>(channelCount)) {
  // A rig that sees nothing has no nodes.
  for (Eigen::Index n = 0; n < nodes.weights.cols(); ++n) {
    for (std::size_t k = 0; k < weights_.size(); ++k) {
      weights_[k].push_back(static_cast<float>(nodes.weights(static_cast<Eigen::Index>(k), n)));
    }
  }
}

void ChannelModel::evaluate(PixelRows<const float> values, std::vector<float>& reflectance,
                            PixelRows<float> channels) const {
  if (response_ != nullptr) {
    std::vector<float*> rows;
    for (std::size_t k = 0; k < channels.rowCount; ++k)
      rows.push_back(channels.row(k));
    return response_->evaluate(values, rows);
  }
  const auto nodeCount = static_cast<std::size_t>(nodes_.nodeCount());
  reflectance.resize(nodeCount * values.count);
  const auto atNodes = packedRows(reflectance.data(), nodeCount, values.count);
  reflectanceBatch<float>(nodes_, values, atNodes);
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    float* channel = channels.row(k);
    std::fill_n(channel, values.count, 0.0f);
    for (std::size_t n = 0; n < nodeCount; ++n) {
      const float weight = weights_[k][n];
      const float* node = atNodes.row(n);
      for (std::size_t i = 0; i < values.count; ++i)
        channel[i] += weight * node[i];
    }
  }
}

}  // namespace cutis
