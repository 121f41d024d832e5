#include <algorithm>
#include <numeric>

#include "core/base/echoed_text.h"
#include "src/images/codec/image_reader.h"
#include "src/images/codec/metadata_access.h"
#include "src/images/color/file_colors.h"
#include "src/images/image_file.h"
#include "src/images/layer_choice.h"
#include "src/images/row_preview.h"

namespace cutis {
namespace {

constexpr double kHashShare = 0.05;  // of the time

// The widest of some channels.
SampleType widestOf(const ImagePart& part, const std::vector<std::string>& channels) {
  SampleType widest = SampleType::uint8;
  for (const std::string& channel : channels) {
    const int index = part.channelIndex(channel);
    if (index >= 0) widest = std::max(widest, part.channelType(index));
  }
  return widest;
}

// A rectangle of the file in pixels of the picture upright.
Rect inPicture(const Rect& rect, const ImagePart& part) {
  const Rect& window = part.window;
  const Rect inWindow = intersection(rect, window);
  if (inWindow.empty()) return {};
  return uprightRect({inWindow.x0 - window.x0, inWindow.y0 - window.y0, inWindow.x1 - window.x0,
                      inWindow.y1 - window.y0},
                     window.width(), window.height(), part.orientation);
}

struct OpenedPart {
  ImagePart part;
  LayerChoice choice;
};

Result<OpenedPart> openPart(ImageReader& reader, const std::string& name, bool overscan,
                            Rect& display) {
  CUTIS_TRY(layers, layersOf(reader));
  CUTIS_TRY(choice, chooseLayer(layers, name, reader.place()));
  CUTIS_TRY(part, reader.part(choice.layer.part));
  display = part.window;
  if (overscan) CUTIS_CHECK(reader.includeOverscan(part));
  return OpenedPart{std::move(part), std::move(choice)};
}

void fillHeader(const std::filesystem::path& path, const OpenedPart& opened, const Rect& display,
                ImageReader& reader, ImageHeader& header) {
  const ImagePart& part = opened.part;
  header.file = reader.place();
  header.kind = reader.kind();
  header.width = part.width();
  header.height = part.height();
  header.frame = {inPicture(display, part), inPicture(part.stored, part), part.window.x0,
                  part.window.y0};
  header.orientation = part.orientation;
  header.layer = opened.choice.layer;
  header.otherLayers = opened.choice.others;
  header.hasFurtherParts = reader.partCount() > 1 || reader.hasFurtherPages();
  header.hasSmallerLevels = reader.levelCount(part.index) > 1;
  if (reader.kind() == ImageFileKind::openExr) {
    header.pixelAspect = part.spec.get_float_attribute("PixelAspectRatio", 1.0f);
  }
  header.alphaKind = part.alphaKind;
  header.channelNames = part.spec.channelnames;
  header.sourceType = widestOf(part, opened.choice.layer.channelNames);
  header.colors = fileColors(path, reader.kind(), part);
  header.metadata = MetadataAccess::from(part.spec);
}

// What was decided without being asked, and what of the file stays unread.
void sayWhatIsRead(const ImageHeader& header, bool isLayerChosen, const JobContext& context) {
  const std::string place = header.file.string();
  const ImageLayer& layer = header.layer;
  if (!header.otherLayers.empty()) {
    context.say(place + ": " + inQuotes(layer.name) + " is read; " +
                layerNames(header.otherLayers) +
                (header.otherLayers.size() == 1 ? " has" : " have") +
                " colours, too, and can be chosen as the layer");
  } else if (!isLayerChosen && layer.colors && !layer.prefix.empty()) {
    context.say(place + ": the layer " + inQuotes(layer.name) +
                " is read, the only one with colours");
  }
  if (header.kind == ImageFileKind::webP && header.hasFurtherParts) {
    context.say(place + ": this is an animation; its first frame alone is read");
  } else if (header.kind != ImageFileKind::openExr && header.hasFurtherParts) {
    context.say(place + ": the file has several pages; the first alone is read");
  }
  if (header.kind == ImageFileKind::webP && layer.alpha >= 0) {
    context.say(place +
                ": where alpha is below 1, colours of a WebP file are read multiplied by it in 8 "
                "bits, which rounds them, and takes them away where it is 0; save it as PNG to "
                "keep them");
  }
}

}  // namespace

bool ImageHeader::isLayerOpen() const {
  return !layer.prefix.empty() && !otherLayers.empty();
}

int ImageHeader::channelIndex(std::string_view name) const {
  const auto found = std::find(channelNames.begin(), channelNames.end(), name);
  return found == channelNames.end() ? -1 : static_cast<int>(found - channelNames.begin());
}

Result<ImageHeader> readImageHeader(const std::filesystem::path& path, const JobContext& context,
                                    const std::string& layer) {
  CUTIS_TRY(reader, ImageReader::open(path, context));
  Rect display;
  CUTIS_TRY(opened, openPart(reader, layer, false, display));
  ImageHeader header;
  fillHeader(path, opened, display, reader, header);
  return header;
}

Result<Image> readImage(const std::filesystem::path& path, const ImageReadOptions& options,
                        const std::shared_ptr<TileStore>& store, const JobContext& context) {
  CUTIS_TRY(reader, ImageReader::open(path, context));
  Rect display;
  CUTIS_TRY(opened, openPart(reader, options.layer, options.overscan, display));
  Image image;
  fillHeader(path, opened, display, reader, image);
  if (options.accept) CUTIS_CHECK(options.accept(image));
  sayWhatIsRead(image, !options.layer.empty(), context);
  CUTIS_TRY(hash, hashFile(path, context));
  image.contentHash = hash;
  const ImagePart& part = opened.part;
  // All of the part's channels share the format.
  const PixelFormat format = options.format.value_or(
      part.type == SampleType::half ? PixelFormat::half : PixelFormat::float32);
  std::vector<int> all(static_cast<std::size_t>(part.spec.nchannels));
  std::iota(all.begin(), all.end(), 0);
  RowsSeen seen;
  if (options.preview)
    seen = rowPreview(part, image.layer, image.colors, *options.preview, context);
  CUTIS_TRY(planes, reader.read(part, all, format, store, context.child(kHashShare, 1.0), seen));
  image.channels = std::move(planes);
  return image;
}

}  // namespace cutis
