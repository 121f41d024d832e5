#pragma once  // internal to src/app/document

// What is known of a place in the picture: of one pixel, or of the mean of a square of pixels.
//
// Spectra are computed exactly, with the constants that were found for each pixel
// (core/render/skin_spectra.h). Of a square they are the mean of the pixels' spectra, not the
// spectrum of their mean parameters; pixels without an estimate are left out. Deviations are then
// the mean of the pixels' own, as if their errors were all the same: what noise there is between
// pixels may make them smaller, never larger.
//
// Thread-safe: const after construction.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/fit/spectrum_posterior.h"
#include "core/rig/channel_extent.h"
#include "src/app/document/scene.h"
#include "src/app/open/fit_choice.h"

namespace cutis {

// One channel of the photographs as a share of the perfect diffuser.
struct ChannelReading {
  std::string name;  // "white.R"
  ChannelExtent extent;
  double measured = 0.0;
  double deviation = 0.0;  // of the noise that the fit assumes
  double modelled = 0.0;   // what the original spectrum gives in this channel
};

struct PlaceSpectra {
  int pixelCount = 1;  // that have an estimate
  ParameterVector originalParameters;
  ParameterVector editedParameters;
  SkinConstants constants;  // of the pixels where they are free, else of the profile
  Spectrum original;
  Spectrum edited;
  // Standard deviation of the original spectrum and parameters given the photographs; none for maps
  // without them, for methods that know none and for photographs with shading.
  std::optional<Spectrum> deviation;
  std::optional<ParameterVector> parameterDeviation;
  // Of the channels that see something; none for maps without photographs and with shading, which
  // no channel tells from skin.
  std::vector<ChannelReading> channels;
};

class SceneSpectra {
 public:
  // About 0.2 ms; reads the choice's prior where it has one.
  SceneSpectra(const Scene& scene, const FitChoice& choice);

  // Nothing where no pixel has an estimate. About 0.3 ms a pixel.
  std::optional<PlaceSpectra> at(int x, int y) const { return mean(x, y, 1); }
  // Of the square of `size` × `size` pixels about a place, as much of it as lies in the picture.
  // size: odd.
  std::optional<PlaceSpectra> mean(int x, int y, int size) const;

  // What the photographs measured (core/rig/channel_extent.h); none for maps without them.
  const std::optional<Band>& measured() const { return measured_; }

 private:
  std::optional<PlaceSpectra> ofPixel(int x, int y) const;
  void addReadings(int x, int y, std::span<const double> values, PlaceSpectra& place) const;

  Scene scene_;
  std::shared_ptr<const SkinSpectra> spectra_;  // null: they could not be made
  bool hasShading_;
  SpectrumRows responses_;  // no rows without photographs
  std::vector<std::optional<ChannelExtent>> extents_;
  std::optional<Band> measured_;
  NoiseModel noise_;
  std::shared_ptr<const SpectrumPosterior> posterior_;  // null: no deviations are known
};

}  // namespace cutis
