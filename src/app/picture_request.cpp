#include "src/app/picture_request.h"

#include "core/base/echoed_text.h"
#include "core/base/number_text.h"
#include "core/render/relight.h"
#include "src/files/spectral_library.h"

namespace cutis {

Result<PictureRows> pictureRows(const PictureRequest& request, const PicturePlaces& places,
                                const Notice& notice) {
  if (request.band) return PictureRows{bandRow(*request.band), false};
  CUTIS_TRY(light, loadLight({request.light, {}, places.light, notice}));
  CUTIS_TRY(eyes, loadCamera({request.observer, {}, places.observer, notice}));
  if (!eyes.isObserver) {
    const SpectrumRows rows = channelRows(light, eyes.sensor);
    if ((rows == 0.0).all()) {
      return inputError(places.light, "camera " + inQuotes(request.observer) +
                                          " sees nothing of light " + inQuotes(request.light) +
                                          "; choose others");
    }
    return PictureRows{rows, false};
  }
  if (!(eyes.sensor.sensitivity.row(1).transpose() * light).any()) {
    return inputError(places.light,
                      "light " + inQuotes(request.light) +
                          " has no visible power; choose a band for ultraviolet or infrared");
  }
  CUTIS_TRY(daylight, loadLight({"D65", {}, places.light}));
  CUTIS_TRY(standard, loadCamera({"cie1931", {}, places.light}));
  return PictureRows{colourRows(light, eyes.sensor, request.adaptation, daylight, standard.sensor),
                     true};
}

Result<Band> parseBand(const std::string& text, const std::string& place) {
  if (text == "uv") return kUltravioletBand;
  if (text == "nir") return kNearInfraredBand;
  const auto colon = text.find(':');
  const auto from = parseNumber(text.substr(0, colon));
  const auto to = colon == std::string::npos ? std::nullopt : parseNumber(text.substr(colon + 1));
  if (!from || !to) {
    return usageError(place, inQuotes(text) + " is not a band; write uv, nir or FROM:TO in nm");
  }
  const Band band = bandBetween(*from, *to);
  if (!(*from <= *to) || band.count() <= 0) {
    return usageError(place,
                      "the band " + text + " contains no wavelength between 300 and 1000 nm");
  }
  return band;
}

}  // namespace cutis
