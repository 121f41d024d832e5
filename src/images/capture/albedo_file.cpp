#include "src/images/capture/albedo_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/base/choice_place.h"
#include "core/base/echoed_text.h"
#include "core/base/parallel.h"
#include "core/spectra/colorimetry.h"
#include "src/images/capture/mask_file.h"
#include "src/images/image_layers.h"

namespace cutis {
namespace {

Status checkRig(const Rig& rig) {
  if (rig.camera.isObserver && rig.lights.size() == 1) return {};
  return usageError(kRigChoice,
                    "a single image needs a rig with a colour-matching observer and one "
                    "light, which " +
                        inQuotes(rig.name) + " is not; use the rig 'albedo' or name a capture");
}

Status checkLayer(const ImageHeader& image, const std::string& place) {
  if (!image.isLayerOpen()) return {};
  std::vector<ImageLayer> meant = image.otherLayers;
  meant.insert(meant.begin(), image.layer);
  return inputError(kLayerChoice, inQuotes(place) + " has no plain channels R, G and B, but " +
                                      layerNames(meant) + " have colours; choose one of them");
}

Status checkHasColors(const ImageHeader& image, const std::vector<ImageLayer>& layers,
                      const std::string& place) {
  if (image.layer.colors) return {};
  std::vector<ImageLayer> colored;
  std::copy_if(layers.begin(), layers.end(), std::back_inserter(colored),
               [](const ImageLayer& layer) { return layer.colors.has_value(); });
  if (!colored.empty()) {
    const std::string what = image.layer.name.empty()
                                 ? "plain channels have"
                                 : "the layer " + inQuotes(image.layer.name) + " has";
    return inputError(place, what + " no red, green and blue; choose a layer with colours: " +
                                 layerNames(colored));
  }
  const bool severalLayers = layers.size() > 1;
  const bool grey = image.channelNames.size() <= 2 && !severalLayers;
  return inputError(place, std::string("the image is ") +
                               (grey ? "grey" : "without the channels R, G and B") +
                               (severalLayers ? " (it has " + layerNames(layers) + ")" : "") +
                               "; skin needs its colours, save it as a colour image");
}

void sayHowColorsAreRead(const ColorDecision& colors, const FileColors& file,
                         const std::string& place, const JobContext& context) {
  const bool usual = colors.followed.source == ColorSource::choice ||
                     colors.followed.source == ColorSource::ownAttribute ||
                     colors.followed.space.name == file.byDefault.space.name;
  if (!usual || file.isConverted) context.say(place + ": " + colors.sentence);
  for (const std::string& contradiction : colors.contradictions)
    context.say(place + ": " + contradiction);
}

// Planes hold floats.
void sayLostBits(const ImageHeader& image, const std::string& place, const JobContext& context) {
  if (image.sourceType != SampleType::uint32 && image.sourceType != SampleType::float64) return;
  context.say(place + ": its samples of type " + sampleTypeName(image.sourceType) +
              " are read as floats, which hold 24 bits of a number; they do not come back bit for "
              "bit");
}

bool isGrey(const ImageHeader& image) {
  return !image.layer.colors && image.layer.prefix.empty() && image.channelIndex("Y") >= 0;
}

// Red, green and blue in place of grey.
void widenGrey(Image& image) {
  const int grey = image.channelIndex("Y");
  const auto at = static_cast<std::ptrdiff_t>(grey);
  const Plane plane = image.channels[static_cast<std::size_t>(grey)];
  image.channelNames.erase(image.channelNames.begin() + at);
  image.channelNames.insert(image.channelNames.begin() + at, {"R", "G", "B"});
  image.channels.insert(image.channels.begin() + at, 2, plane);
  image.layer.colors = {grey, grey + 1, grey + 2};
  if (image.layer.alpha > grey) image.layer.alpha += 2;
  image.isWidenedGrey = true;
}

Result<bool> isZeroEverywhere(const Plane& plane, const JobContext& context) {
  std::atomic<bool> isZero = true;
  CUTIS_CHECK(parallelFor(static_cast<std::size_t>(plane.tileCount()), {context.stop, {}, {}},
                          [&](std::size_t i) -> Status {
                            if (!isZero) return {};
                            const Rect rect = plane.tileRect(static_cast<int>(i));
                            std::vector<float> values(rect.pixelCount());
                            CUTIS_CHECK(plane.load(rect, values));
                            if (std::any_of(values.begin(), values.end(),
                                            [](float v) { return v != 0.0f; }))
                              isZero = false;
                            return {};
                          }));
  return isZero.load();
}

// An alpha that would leave nothing of the picture is one that nobody meant.
Status dropEmptyAlpha(Image& image, const std::string& place, const JobContext& context) {
  if (image.layer.alpha < 0) return {};
  const Plane& alpha = image.channels[static_cast<std::size_t>(image.layer.alpha)];
  CUTIS_TRY(isEmpty, isZeroEverywhere(alpha, context));
  if (!isEmpty) return {};
  context.say(place + ": its alpha is 0 everywhere and is taken for none");
  image.layer.alpha = -1;
  return {};
}

class AlbedoReader {
 public:
  AlbedoReader(Albedo& albedo, ColorConverter toLinear, Plane mask)
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
  ColorConverter toLinear_;
  Plane mask_;
  Plane alpha_;
  Eigen::Matrix3f matrix_;
  bool clips_ = false;
};

}  // namespace

Result<Albedo> readAlbedo(const std::filesystem::path& path, const AlbedoOptions& options,
                          const Rig& rig, const std::shared_ptr<TileStore>& store,
                          const JobContext& context) {
  CUTIS_CHECK(checkRig(rig));
  const std::string place = path.string();
  CUTIS_TRY(layers, listLayers(path, context));
  ColorDecision colors;
  const auto accept = [&](const ImageHeader& header) -> Status {
    CUTIS_CHECK(checkLayer(header, place));
    const bool meantGrey = isGrey(header) && (layers.size() == 1 || !options.layer.empty());
    if (!meantGrey) CUTIS_CHECK(checkHasColors(header, layers, place));
    CUTIS_TRY(decided, decideColors(header.colors, options.colorSpace, place));
    colors = std::move(decided);
    return {};
  };
  const ImageReadOptions read = {
      .accept = accept, .layer = options.layer, .overscan = true, .preview = options.preview};
  CUTIS_TRY(image, readImage(path, read, store, context.child(0.0, 0.7)));
  sayHowColorsAreRead(colors, image.colors, place, context);
  sayLostBits(image, place, context);
  if (isGrey(image)) {
    context.say(place + ": the image is grey; its red, green and blue are taken to be equal" +
                (image.channelNames.size() == 2 && image.layer.alpha < 0
                     ? ", and its second channel, which nothing explains, is not looked at"
                     : ""));
    widenGrey(image);
  }
  CUTIS_CHECK(dropEmptyAlpha(image, place, context));
  Plane mask;
  if (!options.mask.empty()) {
    const MaskedPicture picture = {image.width, image.height, inQuotes(place), image.frame.display,
                                   image.orientation};
    CUTIS_TRY(found, readMask(options.mask, picture, store, context.child(0.7, 0.75)));
    mask = found;
  }
  Albedo albedo;
  albedo.source = std::move(image);
  albedo.colors = colors;
  albedo.measurements.rig = rig;
  AlbedoReader reader(albedo, colors.followed.space.toLinearRec709, mask);
  CUTIS_CHECK(reader.measure(store, context.child(0.75, 1.0)));
  return albedo;
}

}  // namespace cutis
