#include <algorithm>
#include <cmath>

#include "core/base/echoed_text.h"
#include "core/base/parallel.h"
#include "core/base/word_list.h"
#include "src/files/io/file_extension.h"
#include "src/images/capture/capture_file.h"
#include "src/images/capture/capture_manifest.h"
#include "src/images/capture/mask_file.h"
#include "src/images/image_file.h"
#include "src/images/pixels/alpha.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

std::string sizeText(int width, int height) {
  return std::to_string(width) + " × " + std::to_string(height) + " pixels";
}

std::string originText(const ImageFrame& frame) {
  return std::to_string(frame.originX) + ", " + std::to_string(frame.originY);
}

// Where the three channels of the camera are: under its own names, or red, green and blue.
Result<std::array<std::size_t, 3>> cameraChannels(const ImageHeader& image, const Camera& camera,
                                                  const std::string& place) {
  for (const auto& names : {camera.channelNames, {"R", "G", "B"}}) {
    std::array<std::size_t, 3> channels = {};
    bool all = true;
    for (std::size_t c = 0; c < names.size(); ++c) {
      const int index = image.channelIndex(names[c]);
      all = all && index >= 0;
      channels[c] = static_cast<std::size_t>(std::max(index, 0));
    }
    if (all) return channels;
  }
  return inputError(place, "a photograph needs the channels R, G and B; this file has " +
                               wordList(image.channelNames, ", ") + "; save it as a colour image");
}

// One light's photograph as it was read.
struct Photograph {
  std::array<Plane, 3> planes;
  Plane alpha;              // may be empty
  bool multiplied = false;  // the colours are, by alpha
  std::array<float, 3> scale;
  bool integer = false;
  Rect stored;  // what the file holds of the picture
};

// Whether numbers of the space mean the same light as by these curves, for people: a power of 2.2
// stands for sRGB in many files.
bool hasCurves(const ColorSpace& space, const std::array<TransferCurve, 3>& curves) {
  constexpr double kSameForPeople = 0.02;
  constexpr int kSteps = 64;
  if (!space.matrix) return false;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (int i = 0; i <= kSteps; ++i) {
      const double number = static_cast<double>(i) / kSteps;
      const double stated = space.matrix->curves[c].toLight(number);
      if (!(std::abs(stated - curves[c].toLight(number)) <= kSameForPeople)) return false;
    }
  }
  return true;
}

class CaptureReader {
 public:
  CaptureReader(const CaptureManifest& manifest, std::shared_ptr<TileStore> store,
                const JobContext& context)
      : manifest_(manifest), store_(std::move(store)), context_(context) {}

  Result<Capture> read() {
    Capture capture;
    CUTIS_CHECK(readPhotographs(capture));
    CUTIS_CHECK(readTheMask());
    capture.measurements.rig = manifest_.rig;
    capture.measurements.isSimulated = manifest_.isSimulated;
    capture.orientation = first_.orientation;
    capture.encoding = manifest_.encoding.name;
    capture.lights = manifest_.lights;
    CUTIS_CHECK(measure(capture.measurements));
    return capture;
  }

 private:
  Status readPhotographs(Capture& capture) {
    const auto count = static_cast<double>(manifest_.photographs.size());
    for (const CapturePhotograph& entry : manifest_.photographs) {
      const auto done = static_cast<double>(photographs_.size());
      const JobContext part = context_.child(0.9 * done / count, 0.9 * (done + 1.0) / count);
      std::array<std::size_t, 3> channels = {};
      const auto accept = [&](const ImageHeader& header) -> Status {
        CUTIS_CHECK(checkPlace(header, entry));
        CUTIS_CHECK(checkStorage(header, entry));
        CUTIS_CHECK(checkDeclaration(header, entry));
        CUTIS_TRY(found, cameraChannels(header, manifest_.rig.camera, entry.path.string()));
        channels = found;
        return {};
      };
      CUTIS_TRY(image, readImage(entry.path, {{}, accept}, store_, part));
      Photograph photograph;
      for (std::size_t c = 0; c < 3; ++c)
        photograph.planes[c] = image.channels[channels[c]];
      photograph.scale = entry.scale;
      photograph.integer = isInteger(image.sourceType);
      photograph.stored = image.frame.stored;
      sayWhatIsMissing(image, entry, part);
      if (image.layer.alpha >= 0) {
        photograph.alpha = image.channels[static_cast<std::size_t>(image.layer.alpha)];
        photograph.multiplied = image.alphaKind == AlphaKind::associated;
      }
      if (photographs_.empty()) capture.metadata = image.metadata;
      photographs_.push_back(std::move(photograph));
      capture.sources.push_back({entry.file, image.contentHash});
    }
    return {};
  }

  static void sayWhatIsMissing(const Image& image, const CapturePhotograph& entry,
                               const JobContext& context) {
    const Rect whole = {0, 0, image.width, image.height};
    if (intersection(image.frame.stored, whole) == whole) return;
    context.say(entry.path.string() +
                ": the file holds a part of the picture only; pixels beside it are left out");
  }

  // What a photograph says of its own numbers must be what capture.json says: one of them is wrong,
  // and maps of numbers read otherwise than they are meant are far off.
  Status checkDeclaration(const ImageHeader& header, const CapturePhotograph& entry) const {
    const CaptureEncoding& declared = manifest_.encoding;
    const auto& statements = header.colors.statements;
    if (declared.isRaw || statements.empty() || statements.front().space.empty()) return {};
    const ColorStatement& stated = statements.front();
    if (hasCurves(stated.space, declared.curves)) return {};
    const std::string inVersion2 = "write \"cutis_capture\": 2 and \"encoding\": ";
    const std::string wayOut = stated.space.isNamed && stated.space.matrix
                                   ? inVersion2 + "\"" + stated.space.name + "\" into " +
                                         kCaptureFile + " if that is so, or \"raw\""
                                   : "save it as " + declared.name + " if that is so, or " +
                                         inVersion2 + "\"raw\" into " + kCaptureFile;
    return inputError(entry.path.string(),
                      "the capture declares its photographs " + declared.name +
                          ", but this one is " + stated.space.name + ", as " + stated.origin +
                          " says; " + wayOut +
                          " if its numbers are proportional to light all the same");
  }

  // Pixels belong together by their place in the files' common coordinates.
  Status checkPlace(const ImageHeader& header, const CapturePhotograph& entry) {
    if (photographs_.empty()) {
      first_ = header;
      return {};
    }
    const std::string firstName = inQuotes(manifest_.photographs.front().file);
    if (header.width != first_.width || header.height != first_.height) {
      return inputError(entry.path.string(),
                        "the photograph is " + sizeText(header.width, header.height) + " but " +
                            firstName + " is " + sizeText(first_.width, first_.height) +
                            "; all photographs must have the same size");
    }
    const ImageFrame &own = header.frame, &common = first_.frame;
    if (own.originX == common.originX && own.originY == common.originY) return {};
    return inputError(entry.path.string(), "the photograph's display window begins at " +
                                               originText(own) + " but that of " + firstName +
                                               " at " + originText(common) +
                                               "; give all photographs the same display window");
  }

  // What cannot be read as colours holds no numbers of a camera either.
  static Status checkStorage(const ImageHeader& header, const CapturePhotograph& entry) {
    const auto& statements = header.colors.statements;
    if (statements.empty() || statements.front().source != ColorSource::storage) return {};
    return inputError(entry.path.string(),
                      "a photograph of a capture holds the numbers of its camera, and this one is "
                      "stored in other colours; save it as linear RGB");
  }

  Status readTheMask() {
    if (manifest_.mask.empty()) return {};
    const MaskedPicture picture = {first_.width,
                                   first_.height,
                                   inQuotes(manifest_.photographs.front().file),
                                   {},
                                   first_.orientation};
    CUTIS_TRY(mask, readMask(manifest_.mask, picture, store_, context_.child(0.9, 0.95)));
    mask_ = mask;
    return {};
  }

  bool isChanged(const Photograph& photograph) const {
    return photograph.multiplied || !isLinear_ ||
           photograph.scale != std::array<float, 3>{1.0f, 1.0f, 1.0f};
  }

  float lightOf(float number, std::size_t channel) const {
    if (isLinear_) return number;
    return static_cast<float>(manifest_.encoding.curves[channel].toLight(double{number}));
  }

  Status measure(Measurements& measurements) {
    for (Photograph& photograph : photographs_) {
      for (Plane& plane : photograph.planes) {
        measurements.channels.push_back(
            isChanged(photograph) ? Plane(first_.width, first_.height, PixelFormat::float32, store_)
                                  : plane);
      }
    }
    measurements.state = Plane(first_.width, first_.height, PixelFormat::half, store_);
    const auto tiles = static_cast<std::size_t>(measurements.state.tileCount());
    return parallelFor(tiles, context_.child(0.95, 1.0), [&](std::size_t i) {
      return measureTile(measurements.state.tileRect(static_cast<int>(i)), measurements);
    });
  }

  Status measureTile(const Rect& rect, Measurements& measurements) const {
    const std::size_t pixels = rect.pixelCount();
    const std::size_t channels = measurements.channels.size();
    std::vector<float> values(channels * pixels), mask(pixels, 1.0f), state(pixels);
    std::vector<float> alpha(pixels);
    std::vector<char> clipped(pixels, 0);
    if (!mask_.empty()) CUTIS_CHECK(mask_.load(rect, mask));
    for (std::size_t c = 0; c < channels; ++c) {
      const Photograph& photograph = photographs_[c / 3];
      const std::span<float> channel = std::span(values).subspan(c * pixels, pixels);
      CUTIS_CHECK(photograph.planes[c % 3].load(rect, channel));
      if (!photograph.alpha.empty()) {
        CUTIS_CHECK(photograph.alpha.load(rect, alpha));
        if (photograph.multiplied) divideByAlpha(channel, alpha);
        for (std::size_t p = 0; p < pixels; ++p) {
          if (alpha[p] == 0.0f) mask[p] = 0.0f;
        }
      }
      if (!(intersection(photograph.stored, rect) == rect)) {
        for (std::size_t p = 0; p < pixels; ++p) {
          const int x = rect.x0 + static_cast<int>(p) % rect.width();
          const int y = rect.y0 + static_cast<int>(p) / rect.width();
          if (!photograph.stored.contains(x, y)) mask[p] = 0.0f;
        }
      }
      for (std::size_t p = 0; photograph.integer && p < pixels; ++p) {
        if (channel[p] >= 1.0f) clipped[p] = 1;
      }
      if (!isChanged(photograph)) continue;
      for (float& value : channel)
        value = lightOf(value, c % 3) * photograph.scale[c % 3];
      CUTIS_CHECK(measurements.channels[c].store(rect, channel));
    }
    std::vector<float> pixel(channels);
    for (std::size_t p = 0; p < pixels; ++p) {
      for (std::size_t c = 0; c < channels; ++c)
        pixel[c] = values[c * pixels + p];
      state[p] = storedState(classify(pixel, mask[p], clipped[p] != 0));
    }
    return measurements.state.store(rect, state);
  }

  const CaptureManifest& manifest_;
  std::shared_ptr<TileStore> store_;
  const JobContext& context_;
  const bool isLinear_ = manifest_.encoding.isLinear();
  ImageHeader first_;  // of the first photograph
  std::vector<Photograph> photographs_;
  Plane mask_;
};

}  // namespace

bool looksLikeCapture(const fs::path& path) {
  std::error_code ignored;
  return lowerExtension(path) == ".json" || fs::is_directory(path, ignored);
}

Result<Capture> readCapture(const fs::path& path, const CaptureReadOptions& options,
                            const std::shared_ptr<TileStore>& store, const JobContext& context) {
  CUTIS_TRY(manifest, readCaptureManifest(path, options, context.notice));
  return CaptureReader(manifest, store, context).read();
}

}  // namespace cutis
