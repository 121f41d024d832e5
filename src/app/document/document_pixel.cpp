// Parts of src/app/document/document.h: what is known of single pixels.

#include <array>
#include <utility>
#include <vector>

#include "core/fit/discrepancy_choice.h"
#include "core/fit/spectrum_posterior.h"
#include "core/skin/parameter_buffer.h"
#include "src/app/document/document.h"
#include "src/app/fit_method.h"

namespace cutis {
namespace {

// Precondition: the buffer is of one pixel.
ParameterVector onlyPixelOf(const ParameterBuffer& buffer) {
  ParameterVector parameters;
  for (const Parameter k : kParameters) {
    parameters[k] = double{buffer.values[static_cast<std::size_t>(k)].front()};
  }
  return parameters;
}

// The values of one pixel with skin, as they were found and as they are edited.
struct PixelValues {
  ParameterBuffer original;
  ParameterBuffer edited;
};

std::optional<PixelValues> valuesAt(const Scene& scene, int x, int y) {
  if (!scene.maps.state.bounds().contains(x, y)) return std::nullopt;
  const Rect pixel = {x, y, x + 1, y + 1};
  auto original = loadParameters(scene.maps, pixel);
  auto edited = loadEdited(scene, pixel);
  if (!original || !edited || !original.value().present.front()) return std::nullopt;
  return PixelValues{std::move(original).value(), std::move(edited).value()};
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

}  // namespace

std::shared_ptr<const SkinValues> Document::skinOf(const JudgedPixels& pixels,
                                                   const SkinModel& model) {
  return std::make_shared<const SkinValues>(skinValuesOf(pixels, model.profile().axes));
}

std::optional<Document::PixelParameters> Document::parametersAt(int x, int y) const {
  if (!scene_) return std::nullopt;
  const auto values = valuesAt(*scene_, x, y);
  if (!values) return std::nullopt;
  return PixelParameters{onlyPixelOf(values->original), onlyPixelOf(values->edited)};
}

std::optional<Document::PixelSpectra> Document::spectraAt(int x, int y) const {
  if (!scene_) return std::nullopt;
  const auto values = valuesAt(*scene_, x, y);
  if (!values) return std::nullopt;
  // Without constants of the pixels' own it is made at once.
  const auto made =
      scene_->spectra
          ? Result<SkinSpectra>(*scene_->spectra)
          : SkinSpectra::make(scene_->model, {{}, scene_->maps.perPixel().discrepancy}, {});
  if (!made) return std::nullopt;
  const OwnValues own = ownValuesOf(*scene_, values->original);
  const auto reflectance = [&](const ParameterVector& parameters) {
    return made.value().reflectance(parameters, own.constants, own.coefficients);
  };
  PixelSpectra spectra;
  spectra.constants = own.constants;
  spectra.originalParameters = onlyPixelOf(values->original);
  spectra.original = reflectance(spectra.originalParameters);
  spectra.editedParameters = onlyPixelOf(values->edited);
  spectra.edited = reflectance(spectra.editedParameters);
  std::vector<double> found(spectra.originalParameters.begin(), spectra.originalParameters.end());
  found.insert(found.end(), own.coefficients.begin(), own.coefficients.end());
  spectra.deviation = deviationAt(x, y, found);
  return spectra;
}

std::optional<Spectrum> Document::deviationAt(int x, int y, std::span<const double> values) const {
  const bool isKnown = scene_->source != nullptr && choice_.method == FitMethod::refined &&
                       !choice_.shading && scene_->maps.free().count() == 0;
  if (!isKnown) return std::nullopt;
  const Measurements& measurements = scene_->source->measurements;
  const auto options = fitOptions(choice_, scene_->model->profile());
  if (!options) return std::nullopt;
  std::vector<double> channels;
  for (std::size_t k = 0; k < measurements.channels.size(); ++k) {
    std::array<float, 1> value;
    if (!measurements.loadChannel(k, {x, y, x + 1, y + 1}, value)) return std::nullopt;
    channels.push_back(double{value[0]});
  }
  const SpectrumPosterior posterior(*scene_->model, measurements.rig,
                                    suitedTo(measurements, options.value()));
  // While a fit with another profile runs, the maps are still those of the last one.
  if (values.size() != posterior.valueCount()) return std::nullopt;
  return posterior.deviation(channels, values);
}

}  // namespace cutis
