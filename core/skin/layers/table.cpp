#include "core/skin/layers/table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "core/base/content_hash.h"
#include "core/base/parallel.h"
#include "core/skin/profile/absorption.h"

namespace cutis {
namespace {

// Changes whenever the same profile would give other numbers.
constexpr double kForm = 1.0;

TransportOptions transportOptions(const Profile& profile, const LayerTableOptions& options) {
  return {options.streams, profile.refractiveIndex, options.anisotropy, options.illumination};
}

void include(AbsorptionRange& range, double absorption) {
  range.low = std::min(range.low, absorption);
  range.high = std::max(range.high, absorption);
}

struct ProfileOptics {
  explicit ProfileOptics(const Profile& profile)
      : absorption(profile),
        corners(boxCorners(profile)),
        scattering(epidermalScattering(profile)),
        dermalScatter(dermalScattering(profile)) {}
  AbsorptionLaw absorption;
  std::vector<std::vector<double>> corners;
  Spectrum scattering;
  Spectrum dermalScatter;
};

TwoLayers layersAt(const Profile& profile, const ProfileOptics& optics, int sample) {
  TwoLayers layers;
  layers.thickness = profile.epidermalThicknessMm;
  layers.epidermalScattering = optics.scattering[sample];
  layers.dermalScattering = optics.dermalScatter[sample];
  layers.epidermalRange = layers.dermalRange = {std::numeric_limits<double>::infinity(), 0.0};
  for (const std::vector<double>& corner : optics.corners) {
    const LayerPair absorption = optics.absorption.at(sample, corner);
    include(layers.epidermalRange, absorption.epidermal);
    include(layers.dermalRange, absorption.dermal);
  }
  // A box may displace more tissue than there is.
  for (AbsorptionRange* range : {&layers.epidermalRange, &layers.dermalRange})
    range->low = std::max(range->low, 0.0);
  return layers;
}

}  // namespace

LayerTable::LayerTable(std::span<const int> samples,
                       std::vector<LayerPolynomial<double>> polynomials)
    : samples_(samples.begin(), samples.end()), polynomials_(std::move(polynomials)) {
  assert(samples_.size() == polynomials_.size());
  place_.setConstant(-1);
  for (std::size_t i = 0; i < samples_.size(); ++i)
    place_[samples_[i]] = static_cast<int>(i);
}

Result<LayerTable> LayerTable::make(const Profile& profile, std::span<const int> samples,
                                    const LayerTableOptions& options, const JobContext& context) {
  CUTIS_TRY(polynomials, fitLayers(profile, samples, layersOf(profile, samples), options, context));
  return LayerTable(samples, std::move(polynomials));
}

Result<LayerTable> LayerTable::makeWhole(const Profile& profile, const LayerTableOptions& options,
                                         const JobContext& context) {
  std::vector<int> samples(kSampleCount);
  std::iota(samples.begin(), samples.end(), 0);
  return make(profile, samples, options, context);
}

LayerTable LayerTable::restore(std::span<const int> samples,
                               std::span<const LayerPolynomial<double>> polynomials) {
  return LayerTable(samples, {polynomials.begin(), polynomials.end()});
}

const LayerPolynomial<double>& LayerTable::at(int sample) const {
  assert(contains(sample));
  return polynomials_[static_cast<std::size_t>(place_[sample])];
}

TwoLayers layersOf(const Profile& profile, int sample) {
  return layersAt(profile, ProfileOptics(profile), sample);
}

std::vector<TwoLayers> layersOf(const Profile& profile, std::span<const int> samples) {
  const ProfileOptics optics(profile);
  std::vector<TwoLayers> layers;
  for (const int sample : samples)
    layers.push_back(layersAt(profile, optics, sample));
  return layers;
}

Result<std::vector<LayerPolynomial<double>>> fitLayers(const Profile& profile,
                                                       std::span<const int> samples,
                                                       std::span<const TwoLayers> layers,
                                                       const LayerTableOptions& options,
                                                       const JobContext& context) {
  const TransportOptions transport = transportOptions(profile, options);
  std::vector<LayerPolynomial<double>> polynomials(samples.size());
  CUTIS_CHECK(parallelFor(samples.size(), context, [&](std::size_t i) -> Status {
    auto fitted = fitLayerPolynomial(layers[i], transport);
    if (fitted.failed()) {
      const auto nm = std::to_string(kFirstWavelengthNm + kWavelengthStepNm * samples[i]);
      return inputError(profile.name + " at " + nm + " nm", fitted.error().message);
    }
    polynomials[i] = fitted.value();
    return {};
  }));
  return polynomials;
}

std::string layerTableFingerprint(const Profile& profile, const LayerTableOptions& options) {
  return ContentHash()
      .add(fingerprint(profile))
      .add(kForm)
      .add(static_cast<double>(kEpidermalTerms))
      .add(static_cast<double>(kDermalTerms))
      .add(static_cast<double>(options.streams))
      .add(options.anisotropy)
      .add(static_cast<double>(options.illumination))
      .digest();
}

}  // namespace cutis
