#include "core/skin/free/free_layers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Core>

#include "core/skin/layers/diffusion_kernel.h"
#include "core/skin/layers/table.h"
#include "core/skin/layers/table_batch.h"
#include "core/skin/profile/absorption.h"
#include "core/transport/diffusion.h"

namespace cutis {
namespace {

// Where absorptions are looked at to find what any oxygenation spans.
constexpr double kOxygenations[] = {0.0, 0.25, 0.5, 0.75, 1.0};

void include(AbsorptionRange& range, const AbsorptionRange& other) {
  range.low = std::min(range.low, other.low);
  range.high = std::max(range.high, other.high);
}

std::vector<TwoLayers> layersOver(const Profile& profile, std::span<const int> samples,
                                  bool anyOxygenation) {
  std::vector<TwoLayers> layers = layersOf(profile, samples);
  if (!anyOxygenation) return layers;
  for (const double oxygenation : kOxygenations) {
    const std::vector<TwoLayers> others =
        layersOf(withConstants(profile, {oxygenation, profile.epidermalThicknessMm}), samples);
    for (std::size_t s = 0; s < layers.size(); ++s) {
      include(layers[s].epidermalRange, others[s].epidermalRange);
      include(layers[s].dermalRange, others[s].dermalRange);
    }
  }
  return layers;
}

std::vector<double> atSamples(const Spectrum& spectrum, std::span<const int> samples) {
  std::vector<double> values;
  for (const int sample : samples)
    values.push_back(spectrum[sample]);
  return values;
}

}  // namespace

FreeLayers::FreeLayers(const Profile& profile, std::span<const int> samples,
                       ChebyshevWeights weights)
    : ownThicknessMm_(profile.epidermalThicknessMm),
      airFactor_(boundaryFactor(profile.refractiveIndex)),
      epidermalScattering_(atSamples(epidermalScattering(profile), samples)),
      dermalScattering_(atSamples(dermalScattering(profile), samples)),
      ofThickness_(std::move(weights)) {}

Result<FreeLayers> FreeLayers::make(const Profile& profile, std::span<const int> samples,
                                    const FreeConstants& free, const JobContext& context,
                                    int thicknessPoints) {
  ThicknessRange range = {profile.epidermalThicknessMm, profile.epidermalThicknessMm};
  if (free.thickness) {
    CUTIS_TRY(found, thicknessRange(profile));
    range = found;
  }
  FreeLayers layers(profile, samples,
                    ChebyshevWeights(std::log(range.lowMm), std::log(range.highMm),
                                     free.thickness ? thicknessPoints : 1));
  layers.free_ = free.thickness;
  if (profile.layerOptics == LayerOpticsKind::diffusion) return layers;
  std::vector<TwoLayers> wanted = layersOver(profile, samples, free.oxygenation);
  for (int k = 0; k < layers.ofThickness_.count(); ++k) {
    for (TwoLayers& own : wanted)
      own.thickness = std::exp(layers.ofThickness_.points()[static_cast<std::size_t>(k)]);
    const auto parts = static_cast<double>(layers.ofThickness_.count());
    CUTIS_TRY(tables, fitLayers(profile, samples, wanted, {},
                                context.child(k / parts, (k + 1) / parts, "")));
    layers.tables_.insert(layers.tables_.end(), tables.begin(), tables.end());
  }
  return layers;
}

LayerSpectra FreeLayers::evaluate(const LayerStates& states, bool derivatives) const {
  LayerSpectra spectra;
  const std::size_t size = epidermalScattering_.size() * states.count;
  spectra.reflectance.resize(size);
  if (derivatives) {
    spectra.perEpidermalAbsorption.resize(size);
    spectra.perDermalAbsorption.resize(size);
    spectra.perThickness.resize(size);
  }
  if (tables_.empty()) {
    diffuse(states, spectra);
  } else {
    transfer(states, spectra);
  }
  return spectra;
}

void FreeLayers::diffuse(const LayerStates& states, LayerSpectra& spectra) const {
  const std::size_t count = states.count;
  const std::vector<double> own(free_ ? 0 : count, ownThicknessMm_);
  DiffusionArguments arguments = {};
  arguments.layers.airGap = 4.0 / 3.0 * airFactor_;
  arguments.thicknessMm = free_ ? states.thicknessMm : own.data();
  arguments.count = count;
  const auto at = [&](std::vector<double>& values, std::size_t sample) {
    return values.empty() ? nullptr : values.data() + sample * count;
  };
  for (std::size_t s = 0; s < epidermalScattering_.size(); ++s) {
    arguments.node.epidermalScattering = epidermalScattering_[s];
    arguments.node.dermalScattering = dermalScattering_[s];
    arguments.epidermalAbsorption = states.epidermalAbsorption + s * count;
    arguments.dermalAbsorption = states.dermalAbsorption + s * count;
    arguments.reflectance = at(spectra.reflectance, s);
    arguments.perEpidermal = at(spectra.perEpidermalAbsorption, s);
    arguments.perDermal = at(spectra.perDermalAbsorption, s);
    arguments.perThickness = at(spectra.perThickness, s);
    runDiffusionKernel(arguments);
  }
}

void FreeLayers::transfer(const LayerStates& states, LayerSpectra& spectra) const {
  const std::size_t count = states.count, sampleCount = epidermalScattering_.size();
  const bool derivatives = !spectra.perThickness.empty();
  const auto points = static_cast<std::size_t>(ofThickness_.count());
  std::vector<double> logarithms(count);
  for (std::size_t i = 0; i < count; ++i)
    logarithms[i] = std::log(free_ ? states.thicknessMm[i] : ownThicknessMm_);
  // [point][skin]; by the thickness itself.
  auto [weights, slopes] = ofThickness_.at(logarithms);
  for (std::size_t i = 0; i < slopes.size(); ++i)
    slopes[i] /= std::exp(logarithms[i % count]);
  std::vector<double> reflectance(count), perEpidermal(count), perDermal(count);
  LayerTableBatch<double> batch;
  batch.count = count;
  batch.reflectance = reflectance.data();
  if (derivatives) {
    batch.perEpidermalAbsorption = perEpidermal.data();
    batch.perDermalAbsorption = perDermal.data();
  }
  for (std::size_t s = 0; s < sampleCount; ++s) {
    batch.epidermalAbsorption = states.epidermalAbsorption + s * count;
    batch.dermalAbsorption = states.dermalAbsorption + s * count;
    for (std::size_t k = 0; k < points; ++k) {
      evaluateBatch(tables_[k * sampleCount + s], batch);
      const auto addTo = [&](std::vector<double>& sums, const std::vector<double>& shares,
                             const std::vector<double>& values) {
        double* sum = sums.data() + s * count;
        const double* share = shares.data() + k * count;
        for (std::size_t i = 0; i < count; ++i)
          sum[i] += share[i] * values[i];
      };
      addTo(spectra.reflectance, weights, reflectance);
      if (!derivatives) continue;
      addTo(spectra.perEpidermalAbsorption, weights, perEpidermal);
      addTo(spectra.perDermalAbsorption, weights, perDermal);
      addTo(spectra.perThickness, slopes, reflectance);
    }
  }
}

}  // namespace cutis
