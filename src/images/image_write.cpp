#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

#include "core/base/parallel.h"
#include "core/base/word_list.h"
#include "src/files/io/atomic_write.h"
#include "src/images/codec/image_formats.h"
#include "src/images/codec/image_writer.h"
#include "src/images/codec/metadata_access.h"
#include "src/images/codec/oiio_text.h"
#include "src/images/color/output_colors.h"
#include "src/images/exr_edition.h"
#include "src/images/image_file.h"

namespace cutis {
namespace {

std::string listOf(const std::vector<SampleType>& types) {
  std::vector<std::string> names;
  for (const SampleType type : types)
    names.push_back(sampleTypeName(type));
  return wordList(names, ", ");
}

bool isAlpha(const std::string& name) {
  return name == "A" || name == "alpha";
}

// Red, green, blue, alpha and then the others; without the three colours the order of the content.
std::vector<std::size_t> orderedChannels(const std::vector<std::string>& names) {
  const auto rank = [&](std::size_t i) {
    constexpr std::array<std::string_view, 3> colors = {"R", "G", "B"};
    const auto color = std::find(colors.begin(), colors.end(), names[i]);
    if (color != colors.end()) return static_cast<int>(color - colors.begin());
    return isAlpha(names[i]) ? 3 : 4;
  };
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto colors =
      std::count_if(order.begin(), order.end(), [&](auto i) { return rank(i) < 3; });
  if (colors == 3) {
    std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return rank(i) < rank(j); });
  }
  return order;
}

// Which channels the format has a place for, in its order.
std::vector<std::size_t> chosenChannels(const std::vector<std::string>& names,
                                        const ImageFormat& format) {
  const std::vector<std::size_t> ordered = orderedChannels(names);
  if (!format.colorsOnly) return ordered;
  std::vector<std::size_t> kept, alpha;
  for (const std::size_t i : ordered)
    (isAlpha(names[i]) ? alpha : kept).push_back(i);
  if (kept.empty()) std::swap(kept, alpha);
  kept.resize(kept.size() >= 3 ? 3 : 1);
  if (format.holdsAlpha && !alpha.empty()) kept.push_back(alpha.front());
  return kept;
}

// The channels of a chosen layer under the names that every format knows, and nothing else.
ImageContent plainLayer(const ImageContent& content) {
  const ImageLayer& layer = content.source->layer;
  ImageContent plain = content;
  plain.channelNames = {"R", "G", "B"};
  plain.channels.clear();
  for (const int color : *layer.colors)
    plain.channels.push_back(content.channels[static_cast<std::size_t>(color)]);
  if (layer.alpha >= 0) {
    plain.channelNames.emplace_back("A");
    plain.channels.push_back(content.channels[static_cast<std::size_t>(layer.alpha)]);
  }
  return plain;
}

// Only OpenEXR has names for layers; everywhere else the one that was chosen is the picture.
bool isLayerByName(const ImageContent& content) {
  if (!content.source || !content.source->layer.colors) return false;
  const std::array<int, 3>& colors = *content.source->layer.colors;
  for (std::size_t c = 0; c < colors.size(); ++c) {
    constexpr std::array<std::string_view, 3> plain = {"R", "G", "B"};
    if (content.channelNames[static_cast<std::size_t>(colors[c])] != plain[c]) return true;
  }
  return false;
}

ImageContent namedFor(const ImageFormat& format, const ImageContent& content) {
  const bool isExr = format.kind == ImageFileKind::openExr;
  return !isExr && isLayerByName(content) ? plainLayer(content) : content;
}

AlphaKind alphaKindIn(const ImageFormat& format, AlphaKind given) {
  if (format.kind == ImageFileKind::openExr) return AlphaKind::associated;
  return format.kind == ImageFileKind::tiff ? given : AlphaKind::straight;
}

OIIO::ImageSpec plainSpec(const ImageContent& content, const std::vector<std::size_t>& channels,
                          const ImageFormat& format, SampleType type) {
  const Plane& first = content.channels.front();
  OIIO::ImageSpec spec(first.width(), first.height(), static_cast<int>(channels.size()),
                       oiioType(type));
  spec.alpha_channel = -1;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    spec.channelnames[i] = content.channelNames[channels[i]];
    if (isAlpha(spec.channelnames[i])) spec.alpha_channel = static_cast<int>(i);
  }
  if (alphaKindIn(format, content.alphaKind) == AlphaKind::straight) {
    spec.attribute("oiio:UnassociatedAlpha", 1);
  }
  if (!format.compression.empty()) spec.attribute("compression", std::string(format.compression));
  if (format.quality > 0) spec.attribute("CompressionQuality", format.quality);
  if (format.kind == ImageFileKind::jpeg) spec.attribute("jpeg:subsampling", "4:4:4");
  return spec;
}

// The channels in the format's order and convention of alpha.
OutputPart outputPart(const OIIO::ImageSpec& spec, const ImageContent& content,
                      const std::vector<std::size_t>& channels, const ImageFormat& format) {
  OutputPart part{spec, {}};
  for (const std::size_t i : channels) {
    part.channels.push_back(content.channels[i]);
    const std::string& name = content.channelNames[i];
    // Colours come first, see orderedChannels().
    if (name == "R" || name == "G" || name == "B" || name == "Y") ++part.colorCount;
  }
  const auto alpha =
      std::find_if(content.channelNames.begin(), content.channelNames.end(), isAlpha);
  const AlphaKind wanted = alphaKindIn(format, content.alphaKind);
  if (alpha == content.channelNames.end() || wanted == content.alphaKind) return part;
  part.alpha = content.channels[static_cast<std::size_t>(alpha - content.channelNames.begin())];
  part.alphaStep = wanted == AlphaKind::straight ? AlphaStep::divide : AlphaStep::multiply;
  return part;
}

std::string pixelCount(std::size_t pixels) {
  return pixels == 1 ? "1 pixel" : std::to_string(pixels) + " pixels";
}

void sayLosses(const WriteLosses& losses, SampleType type, const std::string& place,
               const JobContext& context) {
  if (losses.clipped > 0) {
    context.say(place + ": the values of " + pixelCount(losses.clipped) + " lie beyond what " +
                sampleTypeName(type) + " samples hold and were clipped");
  }
  if (losses.noNumbers > 0) {
    context.say(place + ": " + pixelCount(losses.noNumbers) +
                (losses.noNumbers == 1 ? " has a value that is" : " have values that are") +
                " no number (NaN), which " + sampleTypeName(type) +
                " samples do not have, and became 0");
  }
  if (losses.hiddenColors > 0) {
    context.say(place + ": " + pixelCount(losses.hiddenColors) +
                " with alpha 0 have a colour, which was kept as it is");
  }
}

// What of the source has no place in a file that is written anew.
void sayLeftOut(const ImageContent& content, const std::string& place, const JobContext& context) {
  const ImageHeader& source = *content.source;
  const bool isExr = source.kind == ImageFileKind::openExr;
  if (source.hasFurtherParts) {
    context.say(place + ": only what was opened of the source is written; its other " +
                (isExr                                ? "parts"
                 : source.kind == ImageFileKind::webP ? "frames"
                                                      : "pages") +
                " are left out");
  }
  if (source.hasSmallerLevels) {
    context.say(place + ": the smaller levels of the source are left out");
  }
  if (source.pixelAspect != 1.0f) {
    context.say(place + ": the source's pixels are not square, which this file does not say");
  }
}

// A picture without what lies around its display window.
Result<ImageContent> croppedToDisplay(const ImageContent& content, const std::string& place,
                                      const JobContext& context) {
  const ImageHeader& source = *content.source;
  const Rect& display = source.frame.display;
  if (display == Rect{0, 0, source.width, source.height}) return content;
  context.say(place + ": only the display window is written; what lies around it is left out");
  ImageContent cropped = content;
  for (Plane& plane : cropped.channels) {
    Plane part(display.width(), display.height(), plane.format());
    const auto tiles = static_cast<std::size_t>(part.tileCount());
    CUTIS_CHECK(parallelFor(tiles, {context.stop, {}, {}}, [&](std::size_t i) -> Status {
      const Rect rect = part.tileRect(static_cast<int>(i));
      std::vector<float> values(rect.pixelCount());
      CUTIS_CHECK(plane.load(
          {rect.x0 + display.x0, rect.y0 + display.y0, rect.x1 + display.x0, rect.y1 + display.y0},
          values));
      return part.store(rect, values);
    }));
    plane = part;
  }
  return cropped;
}

bool isExrEdition(const ImageContent& content, const ImageFormat& format) {
  return format.kind == ImageFileKind::openExr && content.source &&
         content.source->kind == ImageFileKind::openExr && content.source->layer.colors &&
         !content.source->isWidenedGrey && !content.source->colors.isConverted;
}

// A file that changed since it was opened holds other pictures than the ones beside these colours.
Result<bool> isSourceThere(const ImageContent& content, const std::string& place,
                           const JobContext& context) {
  const auto hash = hashFile(content.source->file, context);
  if (hash.cancelled()) return Cancelled{};
  const bool same = hash && hash.value() == content.sourceHash;
  if (!same) {
    context.say(place +
                ": the source has changed since it was opened; only the layer with the "
                "colours is written");
  }
  return same;
}

// What stands in the header of the picture.
struct Headers {
  OIIO::ImageSpec full;
  OIIO::ImageSpec plain;  // without what was carried over
  std::string inserted;
};

Headers headersOf(const OIIO::ImageSpec& plain, const ImageContent& content,
                  const ImageFormat& format, const std::string& place, const JobContext& context) {
  Headers headers = {plain, plain, {}};
  MetadataAccess::add(content.metadata, headers.full);
  StatedColors stated;
  for (OIIO::ImageSpec* spec : {&headers.plain, &headers.full})
    stated = stateColors(format.kind, content.colorSpace, *spec);
  if (!stated.complete) {
    context.say(place + ": " + std::string(format.name) + " cannot say here that its colours are " +
                content.colorSpace.name + "; name it when you use the file");
  }
  headers.inserted = stated.inserted;
  return headers;
}

// All channels of a picture in a file of its own.
Status writeAnew(const std::filesystem::path& path, const ImageContent& given,
                 const ImageFormat& format, SampleType type, const JobContext& context) {
  const std::string place = path.string();
  ImageContent content = namedFor(format, given);
  if (content.source) {
    CUTIS_TRY(cropped, croppedToDisplay(content, place, context));
    content = std::move(cropped);
    sayLeftOut(content, place, context);
  }
  const std::vector<std::size_t> channels = chosenChannels(content.channelNames, format);
  if (content.channels.size() < given.channels.size()) {
    context.say(place + ": only the layer is written; the other channels are left out");
  } else if (channels.size() < given.channels.size()) {
    context.say(place + ": " + std::string(format.name) + " has room for " +
                std::to_string(channels.size()) + " of the " +
                std::to_string(given.channels.size()) + " channels; the others are left out");
  }
  const Headers headers =
      headersOf(plainSpec(content, channels, format, type), content, format, place, context);
  const OutputPart part = outputPart(headers.full, content, channels, format);
  return writeAtomically(path, [&](const std::filesystem::path& temporary) -> Status {
    CUTIS_TRY(losses, writeParts(temporary, place, format.kind, type, {part}, {headers.plain},
                                 headers.inserted, context));
    sayLosses(losses, type, place, context);
    return {};
  });
}

Status writeEdition(const std::filesystem::path& path, const ImageContent& content,
                    const ImageFormat& format, SampleType type, const JobContext& context) {
  const std::string place = path.string();
  const Headers headers =
      headersOf(plainSpec(content, {0}, format, type), content, format, place, context);
  CUTIS_TRY(edition, makeExrEdition(content, headers.full, headers.plain, type, place, context));
  if (!content.isSourceSpace && edition.parts.size() > 1) {
    context.say(place + ": the other parts keep the colour space of the source");
  }
  return writeAtomically(path, [&](const std::filesystem::path& temporary) -> Status {
    CUTIS_CHECK(
        writeParts(temporary, place, format.kind, type, edition.parts, edition.plain, {}, context));
    sayLosses({.clipped = *edition.clipped}, type, place, context);
    return {};
  });
}

}  // namespace

Result<std::vector<SampleType>> writableSampleTypes(const std::filesystem::path& path) {
  CUTIS_TRY(format, writtenFormat(path));
  return format->sampleTypes;
}

Status checkImageOutput(const std::filesystem::path& path, SampleType type) {
  CUTIS_TRY(format, writtenFormat(path));
  const std::vector<SampleType>& types = format->sampleTypes;
  if (std::find(types.begin(), types.end(), type) == types.end()) {
    return usageError(path.string(), std::string(format->name) + " does not hold samples of type " +
                                         sampleTypeName(type) + "; choose " + listOf(types) +
                                         " or another format");
  }
  return checkWritable(path);
}

bool canStateColors(const std::filesystem::path& path, SampleType type, const ColorSpace& space) {
  return canStateColors(writtenFormat(path).value()->kind, type, space);
}

Status writeImage(const std::filesystem::path& path, const ImageContent& content, SampleType type,
                  const JobContext& context) {
  assert(!content.channels.empty() && content.channels.size() == content.channelNames.size());
  CUTIS_CHECK(checkImageOutput(path, type));
  const ImageFormat& format = *writtenFormat(path).value();
  if (!isExrEdition(content, format)) return writeAnew(path, content, format, type, context);
  CUTIS_TRY(isThere, isSourceThere(content, path.string(), context));
  return isThere ? writeEdition(path, content, format, type, context)
                 : writeAnew(path, content, format, type, context);
}

}  // namespace cutis
