#include "core/skin/model/compiled_model.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "core/maths/decay_polynomial.h"
#include "core/skin/layers/polynomial_fit.h"
#include "core/transport/diffusion.h"

namespace cutis {
namespace {

// The optics' polynomials at these samples; null where there are none.
std::shared_ptr<const std::vector<LayerPolynomial<double>>> transportAt(
    const LayerOptics& optics, const std::vector<int>& samples) {
  std::vector<LayerPolynomial<double>> polynomials;
  for (const int sample : samples) {
    const LayerPolynomial<double>* polynomial = optics.polynomialAt(sample);
    if (polynomial == nullptr) return nullptr;
    polynomials.push_back(*polynomial);
  }
  return std::make_shared<const std::vector<LayerPolynomial<double>>>(std::move(polynomials));
}

std::shared_ptr<const std::vector<LayerPolynomial<float>>> single(
    const std::vector<LayerPolynomial<double>>& polynomials) {
  std::vector<LayerPolynomial<float>> rounded;
  for (const auto& polynomial : polynomials)
    rounded.push_back(singlePrecision(polynomial));
  return std::make_shared<const std::vector<LayerPolynomial<float>>>(std::move(rounded));
}

NodeConstants<float> single(const NodeConstants<double>& node,
                            const LayerPolynomial<float>* transport) {
  return {static_cast<float>(node.epidermalScattering),
          static_cast<float>(node.dermalScattering),
          static_cast<float>(node.epidermalBase),
          static_cast<float>(node.pheomelanin),
          static_cast<float>(node.melaninContrast),
          static_cast<float>(node.epidermalBlood),
          static_cast<float>(node.carotene),
          static_cast<float>(node.dermalBase),
          static_cast<float>(node.dermalBlood),
          transport};
}

template <typename T>
LayerConstants<T> layerConstants(const Profile& profile) {
  const double largest = std::sqrt(3.0);
  LayerConstants<T> layers;
  layers.thicknessMm = static_cast<T>(profile.epidermalThicknessMm);
  const double airGap = 4.0 / 3.0 * boundaryFactor(profile.refractiveIndex);
  layers.airGap = static_cast<T>(airGap);
  const auto inner = decayPolynomial<std::size(decltype(layers.innerDecay){})>(1.0 / 3.0, largest);
  const auto air = decayPolynomial<std::size(decltype(layers.airDecay){})>(airGap / 8.0, largest);
  for (std::size_t k = 0; k < inner.size(); ++k)
    layers.innerDecay[k] = static_cast<T>(inner[k]);
  for (std::size_t k = 0; k < air.size(); ++k)
    layers.airDecay[k] = static_cast<T>(air[k]);
  return layers;
}

}  // namespace

CompiledModel::CompiledModel(const SkinModel& model, std::vector<int> samples)
    : samples_(std::move(samples)),
      singleLayers_(layerConstants<float>(model.profile())),
      doubleLayers_(layerConstants<double>(model.profile())) {
  const Spectrum scattering = epidermalScattering(model.profile());
  const Spectrum dermalScatter = dermalScattering(model.profile());
  static_assert(kParameterCount == 5, "a sixth has a coefficient in NodeConstants, filled in here");
  assert(model.profile().further.empty());
  const AbsorptionLaw& law = model.absorption();
  doubleTransport_ = transportAt(model.optics(), samples_);
  if (doubleTransport_) singleTransport_ = single(*doubleTransport_);
  for (std::size_t n = 0; n < samples_.size(); ++n) {
    const int i = samples_[n];
    const double eumelanin = law.perUnit(kMelanin, i), pheomelanin = law.perUnit(kMelaninBlend, i);
    doubleNodes_.push_back({scattering[i], dermalScatter[i], law.base(SkinLayer::epidermis, i),
                            pheomelanin, eumelanin - pheomelanin,
                            law.perUnit(kHaemoglobinEpidermal, i), law.perUnit(kCarotene, i),
                            law.base(SkinLayer::dermis, i), law.perUnit(kHaemoglobinDermal, i),
                            doubleTransport_ ? &(*doubleTransport_)[n] : nullptr});
    singleNodes_.push_back(
        single(doubleNodes_.back(), singleTransport_ ? &(*singleTransport_)[n] : nullptr));
  }
}

template <>
const std::vector<NodeConstants<float>>& CompiledModel::nodes<float>() const {
  return singleNodes_;
}

template <>
const std::vector<NodeConstants<double>>& CompiledModel::nodes<double>() const {
  return doubleNodes_;
}

template <>
const LayerConstants<float>& CompiledModel::layers<float>() const {
  return singleLayers_;
}

template <>
const LayerConstants<double>& CompiledModel::layers<double>() const {
  return doubleLayers_;
}

}  // namespace cutis
