#include "src/images/capture/mask_file.h"

#include <algorithm>
#include <vector>

#include "core/base/parallel.h"
#include "src/images/capture/mask_shape.h"
#include "src/images/image_file.h"
#include "src/images/pixels/alpha.h"

namespace cutis {
namespace {

std::string maskSizeText(int width, int height) {
  return std::to_string(width) + " × " + std::to_string(height);
}

bool hasSize(const ImageHeader& mask, int width, int height) {
  return mask.width == width && mask.height == height;
}

bool fitsDisplay(const ImageHeader& mask, const MaskedPicture& picture) {
  return !picture.display.empty() &&
         hasSize(mask, picture.display.width(), picture.display.height());
}

// Whether the mask was drawn on the picture as it lies in its file, and does not say so itself.
// Only its size tells.
bool liesAlong(const ImageHeader& mask, const MaskedPicture& picture) {
  return swapsSides(picture.orientation) && mask.orientation == Orientation::upright &&
         picture.width != picture.height && hasSize(mask, picture.height, picture.width);
}

Status checkMask(const ImageHeader& mask, const MaskedPicture& picture, const std::string& place) {
  if (mask.isLayerOpen()) {
    return inputError(place,
                      "the mask has several layers with colours and no plain channels R, G and B; "
                      "save the one that is meant as a file of its own");
  }
  if (hasSize(mask, picture.width, picture.height) || fitsDisplay(mask, picture) ||
      liesAlong(mask, picture)) {
    return {};
  }
  return inputError(place, "the mask is " + maskSizeText(mask.width, mask.height) + " pixels but " +
                               picture.name + " is " + maskSizeText(picture.width, picture.height) +
                               "; make them the same size");
}

// Every tile of a plane by what `value` says of it.
template <typename Tile>
Status fillPlane(Plane& plane, const JobContext& context, const Tile& tile) {
  return parallelFor(static_cast<std::size_t>(plane.tileCount()), {context.stop, {}, {}},
                     [&](std::size_t i) -> Status {
                       const Rect rect = plane.tileRect(static_cast<int>(i));
                       std::vector<float> values(rect.pixelCount(), 0.0f);
                       CUTIS_CHECK(tile(rect, values));
                       return plane.store(rect, values);
                     });
}

Result<MaskChannels> channelsOf(const Image& image, const std::shared_ptr<TileStore>& store,
                                const JobContext& context) {
  MaskChannels channels;
  const ImageLayer& layer = image.layer;
  const auto plane = [&](int channel) { return image.channels[static_cast<std::size_t>(channel)]; };
  if (layer.colors) {
    for (const int color : *layer.colors)
      channels.colors.push_back(plane(color));
  } else {
    channels.colors.push_back(plane(layer.alpha == 0 && image.channels.size() > 1 ? 1 : 0));
  }
  if (layer.alpha < 0) return channels;
  channels.alpha = plane(layer.alpha);
  if (image.alphaKind == AlphaKind::straight) return channels;
  for (Plane& color : channels.colors) {
    Plane straight(image.width, image.height, PixelFormat::float32, store);
    CUTIS_CHECK(
        fillPlane(straight, context, [&](const Rect& rect, std::vector<float>& values) -> Status {
          std::vector<float> alpha(values.size());
          CUTIS_CHECK(color.load(rect, values));
          CUTIS_CHECK(channels.alpha.load(rect, alpha));
          divideByAlpha(values, alpha);
          return {};
        }));
    color = straight;
  }
  return channels;
}

Result<Plane> turned(const Plane& mask, const MaskedPicture& picture,
                     const std::shared_ptr<TileStore>& store, const JobContext& context) {
  Plane upright(picture.width, picture.height, PixelFormat::float32, store);
  const auto count = static_cast<std::size_t>(mask.tileCount());
  // One after the other: tiles do not lie on tiles once they are turned.
  for (std::size_t i = 0; i < count; ++i) {
    if (context.stopRequested()) return Cancelled{};
    const Rect rect = mask.tileRect(static_cast<int>(i));
    std::vector<float> values(rect.pixelCount()), turnedValues(rect.pixelCount());
    CUTIS_CHECK(mask.load(rect, values));
    turnUpright(values, rect.width(), rect.height(), picture.orientation, turnedValues);
    CUTIS_CHECK(upright.store(uprightRect(rect, mask.width(), mask.height(), picture.orientation),
                              turnedValues));
  }
  return upright;
}

Result<Plane> placedInDisplay(const Plane& mask, const MaskedPicture& picture,
                              const std::shared_ptr<TileStore>& store, const JobContext& context) {
  Plane whole(picture.width, picture.height, PixelFormat::float32, store);
  const Rect& display = picture.display;
  CUTIS_CHECK(
      fillPlane(whole, context, [&](const Rect& rect, std::vector<float>& values) -> Status {
        const Rect part = intersection(rect, display);
        if (part.empty()) return {};
        std::vector<float> from(part.pixelCount());
        CUTIS_CHECK(mask.load({part.x0 - display.x0, part.y0 - display.y0, part.x1 - display.x0,
                               part.y1 - display.y0},
                              from));
        const auto width = static_cast<std::size_t>(part.width());
        for (int y = part.y0; y < part.y1; ++y) {
          const auto row =
              static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y - part.y0) * width);
          const auto to = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y - rect.y0) *
                                                          static_cast<std::size_t>(rect.width()) +
                                                      static_cast<std::size_t>(part.x0 - rect.x0));
          std::copy_n(from.begin() + row, width, values.begin() + to);
        }
        return {};
      }));
  return whole;
}

void sayWhatWasFound(const FoundMask& found, const std::string& place, const JobContext& context) {
  if (found.shape == MaskShape::alpha && found.colorsDiffer) {
    context.say(place + ": the mask's shape was taken from its alpha, not from its colours");
  }
  if (found.isColored && found.shape != MaskShape::none) {
    context.say(place + ": the mask is coloured; the luminance of its colours was taken");
  }
  if (found.isEmpty) context.say(place + ": the mask is empty, it leaves out every pixel");
  if (found.isFull) context.say(place + ": the mask is full, it includes every pixel");
}

// Upright and lying cannot be told apart where both have the same size.
void sayHowItLies(const ImageHeader& mask, const MaskedPicture& picture, const std::string& place,
                  const JobContext& context) {
  const bool sizeDecides = swapsSides(picture.orientation) && picture.width != picture.height;
  if (picture.orientation == Orientation::upright || mask.orientation != Orientation::upright ||
      sizeDecides) {
    return;
  }
  context.say(place +
              ": the picture lies turned in its file; the mask is taken to stand upright, as the "
              "picture is shown");
}

}  // namespace

Result<Plane> readMask(const std::filesystem::path& path, const MaskedPicture& picture,
                       const std::shared_ptr<TileStore>& store, const JobContext& context) {
  const std::string place = path.string();
  ImageReadOptions options;
  options.format = PixelFormat::float32;
  options.accept = [&](const ImageHeader& mask) { return checkMask(mask, picture, place); };
  // A mask that was drawn over the overscan, too, is known by its size.
  CUTIS_TRY(header, readImageHeader(path, context));
  options.overscan = !fitsDisplay(header, picture);
  CUTIS_TRY(image, readImage(path, options, store, context));
  CUTIS_TRY(channels, channelsOf(image, store, context));
  Plane mask(image.width, image.height, PixelFormat::float32, store);
  CUTIS_TRY(found, findMask(channels, mask, context));
  sayWhatWasFound(found, place, context);
  if (liesAlong(image, picture)) {
    context.say(place + ": the mask lies like the picture in its file and was turned with it");
    return turned(mask, picture, store, context);
  }
  if (hasSize(image, picture.width, picture.height)) {
    sayHowItLies(image, picture, place, context);
    return mask;
  }
  context.say(place +
              ": the mask covers the display window alone; what lies around it is left out");
  return placedInDisplay(mask, picture, store, context);
}

}  // namespace cutis
