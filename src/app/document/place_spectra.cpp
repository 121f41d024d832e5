#include "src/app/document/place_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "core/fit/discrepancy_choice.h"
#include "core/skin/parameter_buffer.h"

namespace cutis {
namespace {

// Precondition: the buffer is of one pixel.
ParameterVector onlyPixelOf(const ParameterBuffer& buffer) {
  ParameterVector parameters;
  for (const Parameter k : kParameters)
    parameters[k] = double{buffer.values[static_cast<std::size_t>(k)].front()};
  return parameters;
}

// What the rows after the parameters hold: the constants that the fit found itself, and the
// coefficients of the discrepancy.
struct OwnValues {
  SkinConstants constants;
  std::vector<double> coefficients;
};

OwnValues ownValuesOf(const Scene& scene, const ParameterBuffer& buffer) {
  OwnValues own{constantsOf(scene.model->profile()), {}};
  const FreeConstants free = scene.maps.free();
  std::size_t row = kParameterCount;
  for (const SkinConstant constant : kSkinConstants) {
    if (free.has(constant)) own.constants[constant] = double{buffer.values[row++].front()};
  }
  while (row < buffer.values.rowCount())
    own.coefficients.push_back(double{buffer.values[row++].front()});
  return own;
}

// Without constants of the pixels' own they are made at once.
std::shared_ptr<const SkinSpectra> spectraOf(const Scene& scene) {
  if (scene.spectra) return scene.spectra;
  auto made = SkinSpectra::make(scene.model, {{}, scene.maps.perPixel().discrepancy}, {});
  return made ? std::make_shared<const SkinSpectra>(std::move(made).value()) : nullptr;
}

// The sum of what is known of pixels, each of which knows the same.
void add(const PlaceSpectra& more, PlaceSpectra& sum) {
  sum.pixelCount += more.pixelCount;
  sum.originalParameters += more.originalParameters;
  sum.editedParameters += more.editedParameters;
  for (const SkinConstant constant : kSkinConstants)
    sum.constants[constant] += more.constants[constant];
  sum.original += more.original;
  sum.edited += more.edited;
  if (sum.deviation) *sum.deviation += *more.deviation;
  if (sum.parameterDeviation) *sum.parameterDeviation += *more.parameterDeviation;
  for (std::size_t k = 0; k < sum.channels.size(); ++k) {
    sum.channels[k].measured += more.channels[k].measured;
    sum.channels[k].deviation += more.channels[k].deviation;
    sum.channels[k].modelled += more.channels[k].modelled;
  }
}

void divide(double count, PlaceSpectra& sum) {
  sum.originalParameters /= count;
  sum.editedParameters /= count;
  for (const SkinConstant constant : kSkinConstants)
    sum.constants[constant] /= count;
  sum.original /= count;
  sum.edited /= count;
  if (sum.deviation) *sum.deviation /= count;
  if (sum.parameterDeviation) *sum.parameterDeviation /= count;
  for (ChannelReading& channel : sum.channels) {
    channel.measured /= count;
    channel.deviation /= count;
    channel.modelled /= count;
  }
}

bool knowsTheSame(const PlaceSpectra& a, const PlaceSpectra& b) {
  return a.deviation.has_value() == b.deviation.has_value() &&
         a.channels.size() == b.channels.size();
}

}  // namespace

SceneSpectra::SceneSpectra(const Scene& scene, const FitChoice& choice)
    : scene_(scene), spectra_(spectraOf(scene)), hasShading_(choice.shading) {
  if (scene.source == nullptr) return;
  const Measurements& measurements = scene.source->measurements;
  responses_ = responseRows(measurements.rig);
  measured_ = measuredBand(responses_);
  for (Eigen::Index k = 0; k < responses_.rows(); ++k)
    extents_.push_back(channelExtent(responses_.row(k).transpose()));
  noise_ = measurements.rig.noise;
  const auto options = fitOptions(choice, scene.model->profile());
  if (!options) return;
  noise_ = options.value().noise.value_or(noise_);
  if (choice.method != FitMethod::refined || hasShading_ || scene.maps.free().count() > 0) return;
  posterior_ = std::make_shared<const SpectrumPosterior>(*scene_.model, measurements.rig,
                                                         suitedTo(measurements, options.value()));
}

std::optional<PlaceSpectra> SceneSpectra::mean(int x, int y, int size) const {
  const int reach = size / 2;
  std::optional<PlaceSpectra> sum;
  for (int row = y - reach; row <= y + reach; ++row) {
    for (int column = x - reach; column <= x + reach; ++column) {
      const auto pixel = ofPixel(column, row);
      if (!pixel) continue;
      if (!sum) {
        sum = pixel;
      } else if (knowsTheSame(*pixel, *sum)) {
        add(*pixel, *sum);
      }
    }
  }
  if (sum) divide(sum->pixelCount, *sum);
  return sum;
}

std::optional<PlaceSpectra> SceneSpectra::ofPixel(int x, int y) const {
  if (spectra_ == nullptr || !scene_.maps.state.bounds().contains(x, y)) return std::nullopt;
  const Rect pixel = {x, y, x + 1, y + 1};
  const auto original = loadParameters(scene_.maps, pixel);
  const auto edited = loadEdited(scene_, pixel);
  if (!original || !edited || !original.value().present.front()) return std::nullopt;
  const OwnValues own = ownValuesOf(scene_, original.value());
  const auto reflectance = [&](const ParameterVector& parameters) {
    return spectra_->reflectance(parameters, own.constants, own.coefficients);
  };
  PlaceSpectra place;
  place.constants = own.constants;
  place.originalParameters = onlyPixelOf(original.value());
  place.editedParameters = onlyPixelOf(edited.value());
  place.original = reflectance(place.originalParameters);
  const bool isEdited = (place.originalParameters != place.editedParameters).any();
  place.edited = isEdited ? reflectance(place.editedParameters) : place.original;
  std::vector<double> found(place.originalParameters.begin(), place.originalParameters.end());
  found.insert(found.end(), own.coefficients.begin(), own.coefficients.end());
  addReadings(x, y, found, place);
  return place;
}

void SceneSpectra::addReadings(int x, int y, std::span<const double> values,
                               PlaceSpectra& place) const {
  if (scene_.source == nullptr || hasShading_) return;
  const Measurements& measurements = scene_.source->measurements;
  std::vector<double> channels;
  for (std::size_t k = 0; k < measurements.channels.size(); ++k) {
    std::array<float, 1> value;
    if (!measurements.loadChannel(k, {x, y, x + 1, y + 1}, value)) return;
    channels.push_back(double{value[0]});
  }
  for (std::size_t k = 0; k < channels.size(); ++k) {
    if (!extents_[k]) continue;
    const auto row = static_cast<Eigen::Index>(k);
    place.channels.push_back({measurements.rig.channelName(static_cast<int>(k)), *extents_[k],
                              channels[k], std::sqrt(noise_.variance(channels[k])),
                              (responses_.row(row).transpose() * place.original).sum()});
  }
  // While a fit with another profile runs, the maps are still those of the last one.
  if (posterior_ == nullptr || values.size() != posterior_->valueCount()) return;
  const auto deviations = posterior_->deviations(channels, values);
  place.deviation = deviations.reflectance;
  place.parameterDeviation = deviations.parameters;
}

}  // namespace cutis
