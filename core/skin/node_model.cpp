#include "core/skin/node_model.h"

#include <utility>

#include "core/skin/diffusion.h"

namespace cutis {
namespace {

NodeConstants<float> single(const NodeConstants<double>& node) {
  return {static_cast<float>(node.epidermalScattering), static_cast<float>(node.dermalScattering),
          static_cast<float>(node.epidermalBase),       static_cast<float>(node.pheomelanin),
          static_cast<float>(node.melaninContrast),     static_cast<float>(node.epidermalBlood),
          static_cast<float>(node.carotene),            static_cast<float>(node.dermalBase),
          static_cast<float>(node.dermalBlood)};
}

}  // namespace

NodeModel::NodeModel(const SkinModel& model, std::vector<int> samples)
    : samples_(std::move(samples)),
      layers_{model.profile().epidermalThicknessMm,
              4.0 / 3.0 * boundaryFactor(model.profile().refractiveIndex)} {
  const Spectrum scattering = epidermalScattering(model.profile());
  const EpidermalAbsorption& epidermis = model.epidermis();
  const DermalAbsorption& dermis = model.dermis();
  for (const int i : samples_) {
    doubleNodes_.push_back({scattering[i], model.profile().dermalScatteringRatio * scattering[i],
                            epidermis.base[i], epidermis.pheomelanin[i],
                            epidermis.eumelanin[i] - epidermis.pheomelanin[i], epidermis.blood[i],
                            epidermis.carotene[i], dermis.base[i], dermis.blood[i]});
    singleNodes_.push_back(single(doubleNodes_.back()));
  }
}

template <>
const std::vector<NodeConstants<float>>& NodeModel::nodes<float>() const {
  return singleNodes_;
}

template <>
const std::vector<NodeConstants<double>>& NodeModel::nodes<double>() const {
  return doubleNodes_;
}

}  // namespace cutis
