#pragma once

// Pictures in files.
//
// The formats that are read and written, with their sample types: src/images/codec/image_formats.h.
// What is read is recognised by its content and not by its name.
//
// Values: unsigned integers are value / maximum in [0, 1], without linearisation; floats as they
// are, with NaN, infinities and negatives. Colours stay as they are stored, straight or multiplied
// by alpha (src/images/pixels/alpha.h); each format is written in its own convention: OpenEXR
// multiplied, PNG straight, TIFF as its source. Integers are written clamped and rounded without
// dithering, NaN as 0; half holds ±65504, beyond is infinite; how many pixels that cuts off is a
// notice. Pictures are turned upright once, while they are read, and written upright without a tag.
// A picture of an OpenEXR file is its display window, 0 where nothing is stored, and on demand what
// is stored around it.
//
// Errors are sentences about the file; a picture larger than 32768 a side, 2^30 pixels or 256
// channels is refused. The stop token is looked at every few million samples.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"
#include "src/images/codec/image_formats.h"
#include "src/images/codec/metadata.h"
#include "src/images/codec/sample_type.h"
#include "src/images/color/color_statement.h"
#include "src/images/image_layers.h"
#include "src/images/pixels/alpha.h"
#include "src/images/pixels/orientation.h"

namespace cutis {

struct PreviewSink;

// Where a picture lies in its file, in pixels of the picture. Both are all of it except for
// OpenEXR.
struct ImageFrame {
  Rect display;  // what is to be shown; there may be overscan around it
  Rect stored;   // what the file holds; the rest is 0
  // Where the picture's first pixel is in the file's own coordinates; 0 except for OpenEXR.
  int originX = 0;
  int originY = 0;
};

struct ImageHeader {
  std::filesystem::path file;
  ImageFileKind kind = ImageFileKind::png;
  int width = 0;
  int height = 0;
  ImageFrame frame;
  // How the picture lies in its file; it has been turned upright.
  Orientation orientation = Orientation::upright;
  // The part that was read, and which of its channels are colours and alpha.
  ImageLayer layer;
  // Where none was chosen: further layers with colours that could be meant as well.
  std::vector<ImageLayer> otherLayers;
  bool hasFurtherParts = false;   // or pages or frames, of which nothing was read
  bool hasSmallerLevels = false;  // of the same picture
  bool isWidenedGrey = false;     // R, G and B stand for the one channel Y of the file
  float pixelAspect = 1.0f;       // width of a pixel as a multiple of its height
  AlphaKind alphaKind = AlphaKind::straight;
  // "R", "G", "B", "A", "Y" or whatever the file calls them: all channels of the part.
  std::vector<std::string> channelNames;
  SampleType sourceType = SampleType::uint8;  // the widest of the layer's channels
  // All that the file says of its colours.
  FileColors colors;
  ImageMetadata metadata;

  // Whether nothing tells which of several layers is meant: none was chosen, and none has plain
  // channels. The first of them is only a guess.
  bool isLayerOpen() const;
  // -1 if there is none of that name.
  int channelIndex(std::string_view name) const;
};

struct Image : ImageHeader {
  std::vector<Plane> channels;  // one per name, all of one size
  // ContentHash of the file.
  std::string contentHash;
};

// layer: a name of listLayers(); empty: the first with plain R, G and B, else the first with
// colours, else the first.
Result<ImageHeader> readImageHeader(const std::filesystem::path& path, const JobContext& context,
                                    const std::string& layer = {});

struct ImageReadOptions {
  // The format of the planes; none: what holds the file's samples without loss, half for halves and
  // else float. A half plane holds 8 bits well enough for display only: v / 255 is not a half.
  std::optional<PixelFormat> format = {};
  // Looks at the header before any pixel is read; what it objects to is the reader's error. May be
  // empty.
  std::function<Status(const ImageHeader& header)> accept = {};
  std::string layer = {};  // as for readImageHeader()
  bool overscan = false;   // what is stored outside of the display window, too
  // Sees the picture while it is read (src/images/preview/image_preview.h); null: nobody does.
  const PreviewSink* preview = nullptr;
};

// Notices say what was decided without being asked and what stays unread. Whoever reads without a
// choice of the layer refuses a picture whose isLayerOpen().
Result<Image> readImage(const std::filesystem::path& path, const ImageReadOptions& options,
                        const std::shared_ptr<TileStore>& store, const JobContext& context);

struct ImageContent {
  std::vector<std::string> channelNames;
  std::vector<Plane> channels;  // one per name, all of one size, at least one
  // Empty says nothing about the colours.
  ColorSpace colorSpace;
  ImageMetadata metadata;
  // How colours named R, G and B or Y are stored where there is an alpha.
  AlphaKind alphaKind = AlphaKind::straight;
  // What a changed picture was read from. Channels are those of the source, in its order.
  std::optional<ImageHeader> source = {};
  bool isSourceSpace = true;    // the colours are in the source's colour space
  std::string sourceHash = {};  // ContentHash of its file, by which it is known to be the same
};

// What the format of this name can hold, the most usual first. A usage error for other formats.
Result<std::vector<SampleType>> writableSampleTypes(const std::filesystem::path& path);
// Whether this could be written, found out before any work is done: format, sample type, folder.
Status checkImageOutput(const std::filesystem::path& path, SampleType type);

// Whether a file of this name and samples can say that its colours are of this space. Precondition:
// a format that is written.
bool canStateColors(const std::filesystem::path& path, SampleType type, const ColorSpace& space);

// Replaces the file as a whole or leaves it as it was. Channels the format has no place for are
// left out with a notice. A changed OpenEXR picture that is written as OpenEXR keeps windows,
// parts, channels and their types, tiles and smaller levels of its source, which is read again for
// that; a notice says what was left out.
Status writeImage(const std::filesystem::path& path, const ImageContent& content, SampleType type,
                  const JobContext& context);

}  // namespace cutis
