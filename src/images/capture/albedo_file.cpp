#include "src/images/capture/albedo_file.h"

#include <algorithm>
#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/base/choice_place.h"
#include "core/base/echoed_text.h"
#include "core/base/parallel.h"
#include "core/spectra/colorimetry.h"
#include "src/images/capture/mask_file.h"

namespace cutis {
namespace {

Status checkRig(const Rig& rig) {
  if (rig.camera.isObserver && rig.lights.size() == 1) return {};
  return usageError(kRigChoice,
                    "a single image needs a rig with a colour-matching observer and one "
                    "light, which " +
                        inQuotes(rig.name) + " is not; use the rig 'albedo' or name a capture");
}

Result<std::array<std::size_t, 3>> colorChannels(const ImageHeader& image,
                                                 const std::string& place) {
  constexpr std::array<const char*, 3> names = {"R", "G", "B"};
  std::array<std::size_t, 3> channels = {};
  for (std::size_t c = 0; c < names.size(); ++c) {
    const int index = image.channelIndex(names[c]);
    if (index < 0) {
      const bool grey = image.channelNames.size() <= 2;
      return inputError(place, std::string("the image is ") +
                                   (grey ? "grey" : "without the channels R, G and B") +
                                   "; skin needs its colours, save it as a colour image");
    }
    channels[c] = static_cast<std::size_t>(index);
  }
  return channels;
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
    CUTIS_TRY(given, lookup(options.colorSpace, kColorSpaceChoice));
    return Conversion{options.colorSpace, given};
  }
  const bool says = !image.colorSpace.empty();
  const std::string space = says ? image.colorSpace : defaultSpace(image.sourceType);
  const auto found = lookup(space, place);
  if (found) return Conversion{space, found.value()};
  if (!found.failed() || !says) return found.failure();
  return inputError(place, "the file says that its colours are " + inQuotes(space) +
                               ", which is not known; name their colour space, for example " +
                               defaultSpace(image.sourceType));
}

class AlbedoReader {
 public:
  AlbedoReader(Albedo& albedo, std::array<std::size_t, 3> channels, RgbConversion toLinear,
               Plane mask)
      : albedo_(albedo), channels_(channels), toLinear_(std::move(toLinear)), mask_(mask) {
    const Rig& rig = albedo.measurements.rig;
    const Eigen::Vector3d white = whitePoint(rig.lights.front().power, rig.camera.sensor);
    const Eigen::Matrix3d matrix = white.cwiseInverse().asDiagonal() * xyzFromRec709(white);
    matrix_ = matrix.cast<float>();
    clips_ = isInteger(albedo.source.sourceType);
    const int alpha = albedo.source.channelIndex("A");
    if (alpha >= 0) alpha_ = albedo.source.channels[static_cast<std::size_t>(alpha)];
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
    for (std::size_t c = 0; c < 3; ++c) {
      CUTIS_CHECK(albedo_.source.channels[channels_[c]].load(rect, plane));
      for (std::size_t p = 0; p < pixels; ++p) {
        rgb[3 * p + c] = plane[p];
        if (clips_ && plane[p] >= 1.0f) clipped[p] = 1;
      }
    }
    if (!mask_.empty()) CUTIS_CHECK(mask_.load(rect, mask));
    if (!alpha_.empty()) CUTIS_CHECK(alpha_.load(rect, alpha));
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
  std::array<std::size_t, 3> channels_;
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
  std::array<std::size_t, 3> channels = {};
  const auto accept = [&](const ImageHeader& header) -> Status {
    CUTIS_TRY(found, colorChannels(header, place));
    channels = found;
    return {};
  };
  CUTIS_TRY(image, readImage(path, {{}, accept}, store, context.child(0.0, 0.7)));
  CUTIS_TRY(conversion, conversionFor(image, options, toLinearRec709, place));
  Plane mask;
  if (!options.mask.empty()) {
    CUTIS_TRY(read, readMask(options.mask, image.width, image.height, inQuotes(place), store,
                             context.child(0.7, 0.75)));
    mask = read;
  }
  Albedo albedo;
  albedo.source = std::move(image);
  albedo.colorSpace = conversion.space;
  albedo.measurements.rig = rig;
  AlbedoReader reader(albedo, channels, conversion.toLinear, mask);
  CUTIS_CHECK(reader.measure(store, context.child(0.75, 1.0)));
  return albedo;
}

}  // namespace cutis
