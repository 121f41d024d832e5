#include "src/images/capture/albedo_file.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include <Eigen/Core>

#include "core/base/parallel.h"
#include "core/spectra/colorimetry.h"
#include "src/images/capture/mask_file.h"
#include "src/images/image_layers.h"

namespace cutis {
namespace {

Status checkRig(const Rig& rig) {
  if (rig.camera.isObserver && rig.lights.size() == 1) return {};
  return usageError("--rig",
                    "a single image needs a rig with a colour-matching observer and one "
                    "light, which '" +
                        rig.name + "' is not; use the rig 'albedo' or name a capture");
}

Status checkHasColors(const ImageHeader& image, const std::vector<ImageLayer>& layers,
                      const std::string& place) {
  if (image.layer.colors) return {};
  const bool severalLayers = layers.size() > 1;
  const bool othersHave = std::any_of(layers.begin(), layers.end(),
                                      [](const ImageLayer& layer) { return layer.colors; });
  if (severalLayers && othersHave) {
    std::vector<ImageLayer> colored;
    std::copy_if(layers.begin(), layers.end(), std::back_inserter(colored),
                 [](const ImageLayer& layer) { return layer.colors.has_value(); });
    const std::string what = image.layer.name.empty() ? "the image has no plain channels R, G and B"
                                                      : "the layer '" + image.layer.name +
                                                            "' has no red, green and blue";
    return inputError(place, what + "; choose a layer with colours: " + layerNames(colored));
  }
  const bool grey = image.channelNames.size() <= 2 && !severalLayers;
  return inputError(place, std::string("the image is ") +
                               (grey ? "grey" : "without the channels R, G and B") +
                               (severalLayers ? " (it has " + layerNames(layers) + ")" : "") +
                               "; skin needs its colours, save it as a colour image");
}

std::string defaultSpace(SampleType type) {
  return isInteger(type) ? "sRGB" : "Linear Rec.709";
}

struct Conversion {
  std::string space;
  RgbConversion toLinear;
};

Result<Conversion> conversionFor(const Image& image, const AlbedoOptions& options,
                                 const RgbConversionLookup& lookup, const std::string& place) {
  if (!options.colorSpace.empty()) {
    CUTIS_TRY(given, lookup(options.colorSpace, "--colorspace"));
    return Conversion{options.colorSpace, given};
  }
  const bool says = !image.colorSpace.empty();
  const std::string space = says ? image.colorSpace : defaultSpace(image.sourceType);
  const auto found = lookup(space, place);
  if (found) return Conversion{space, found.value()};
  if (!found.failed() || !says) return found.failure();
  return inputError(place, "the file says that its colours are '" + space +
                               "', which is not known; name their colour space, for example " +
                               defaultSpace(image.sourceType));
}

class AlbedoReader {
 public:
  AlbedoReader(Albedo& albedo, RgbConversion toLinear, Plane mask)
      : albedo_(albedo), toLinear_(std::move(toLinear)), mask_(std::move(mask)) {
    const Rig& rig = albedo.measurements.rig;
    const Eigen::Vector3d white = whitePoint(rig.lights.front().power, rig.camera.sensor);
    const Eigen::Matrix3d matrix = white.cwiseInverse().asDiagonal() * xyzFromRec709(white);
    matrix_ = matrix.cast<float>();
    clips_ = isInteger(albedo.source.sourceType);
    const ImageLayer& layer = albedo.source.layer;
    for (std::size_t c = 0; c < 3; ++c)
      colors_[c] = albedo.source.channels[static_cast<std::size_t>((*layer.colors)[c])];
    if (layer.alpha >= 0) alpha_ = albedo.source.channels[static_cast<std::size_t>(layer.alpha)];
  }

  Status measure(const std::shared_ptr<TileStore>& store, const JobContext& context) {
    Measurements& m = albedo_.measurements;
    const int width = albedo_.source.width, height = albedo_.source.height;
    for (int c = 0; c < 3; ++c) {
      m.channels.emplace_back(width, height, PixelFormat::float32, store);
    }
    m.state = Plane(width, height, PixelFormat::half, store);
    return parallelFor(static_cast<std::size_t>(m.state.tileCount()), context, [&](std::size_t i) {
      return measureTile(m.state.tileRect(static_cast<int>(i)));
    });
  }

 private:
  Status measureTile(const Rect& rect) const {
    const std::size_t pixels = rect.pixelCount();
    std::vector<float> plane(pixels), rgb(3 * pixels), mask(pixels, 1.0f), alpha(pixels, 1.0f);
    std::vector<char> clipped(pixels, 0);
    if (!alpha_.empty()) CUTIS_CHECK(alpha_.load(rect, alpha));
    const bool multiplied = albedo_.source.alphaKind == AlphaKind::associated;
    for (std::size_t c = 0; c < 3; ++c) {
      CUTIS_CHECK(colors_[c].load(rect, plane));
      if (multiplied) divideByAlpha(plane, alpha);
      for (std::size_t p = 0; p < pixels; ++p) {
        rgb[3 * p + c] = plane[p];
        if (clips_ && plane[p] >= 1.0f) clipped[p] = 1;
      }
    }
    if (!mask_.empty()) CUTIS_CHECK(mask_.load(rect, mask));
    CUTIS_CHECK(toLinear_(rgb));
    std::vector<float> state(pixels);
    for (std::size_t p = 0; p < pixels; ++p) {
      const Eigen::Vector3f xyz = matrix_ * Eigen::Map<const Eigen::Vector3f>(&rgb[3 * p]);
      std::copy_n(xyz.data(), 3, &rgb[3 * p]);
      const float included = alpha[p] == 0.0f ? 0.0f : mask[p];
      state[p] = storedState(classify(std::span(rgb).subspan(3 * p, 3), included, clipped[p] != 0));
    }
    return store(rect, rgb, plane, state);
  }

  Status store(const Rect& rect, const std::vector<float>& xyz, std::vector<float>& plane,
               const std::vector<float>& state) const {
    Measurements& m = albedo_.measurements;
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t p = 0; p < plane.size(); ++p)
        plane[p] = xyz[3 * p + c];
      CUTIS_CHECK(m.channels[c].store(rect, plane));
    }
    return m.state.store(rect, state);
  }

  Albedo& albedo_;
  std::array<Plane, 3> colors_;
  RgbConversion toLinear_;
  Plane mask_;
  Plane alpha_;
  Eigen::Matrix3f matrix_;
  bool clips_ = false;
};

}  // namespace

Result<Albedo> readAlbedo(const std::filesystem::path& path, const AlbedoOptions& options,
                          const RgbConversionLookup& toLinearRec709, const Rig& rig,
                          const std::shared_ptr<TileStore>& store, const JobContext& context) {
  CUTIS_CHECK(checkRig(rig));
  const std::string place = path.string();
  CUTIS_TRY(layers, listLayers(path, context));
  const ImageReadOptions reading = {
      .accept = [&](const ImageHeader& header) { return checkHasColors(header, layers, place); },
      .layer = options.layer,
      .overscan = true};
  CUTIS_TRY(image, readImage(path, reading, store, context.child(0.0, 0.7)));
  CUTIS_TRY(conversion, conversionFor(image, options, toLinearRec709, place));
  Plane mask;
  if (!options.mask.empty()) {
    const MaskedPicture picture = {image.width, image.height, "'" + place + "'",
                                   image.frame.display, image.orientation};
    CUTIS_TRY(read, readMask(options.mask, picture, store, context.child(0.7, 0.75)));
    mask = read;
  }
  Albedo albedo;
  albedo.source = std::move(image);
  albedo.colorSpace = conversion.space;
  albedo.measurements.rig = rig;
  AlbedoReader reader(albedo, conversion.toLinear, mask);
  CUTIS_CHECK(reader.measure(store, context.child(0.75, 1.0)));
  return albedo;
}

}  // namespace cutis
