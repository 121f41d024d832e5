#pragma once

// An open picture file, part by part, without trust in what it says. For the files of this folder.
//
// Everything OpenImageIO throws or reports ends up as one sentence that names the file. Memory is
// bounded by bands of rows, whatever the header asks for. Not thread-safe.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "src/files/system/error_stream.h"
#include "src/images/codec/sample_type.h"
#include "src/images/codec/source_file.h"
#include "src/images/codec/stored_colors.h"
#include "src/images/pixels/alpha.h"
#include "src/images/pixels/orientation.h"

namespace cutis {

// Larger pictures are taken for damaged or hostile files.
inline constexpr int kLargestSide = 32768;
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 30;
inline constexpr int kMostChannels = 256;
inline constexpr int kMostParts = 64;

struct ImagePart {
  int index = 0;
  int level = 0;     // the picture itself, or a smaller version of it
  std::string name;  // of a part of a multi-part EXR
  // The picture: the display window of an EXR, else all that is stored.
  Rect window;
  // What is stored, in the same coordinates; the rest of the picture is 0.
  Rect stored;
  // How the picture lies in the file. Planes that are read stand upright.
  Orientation orientation = Orientation::upright;
  AlphaKind alphaKind = AlphaKind::straight;
  SampleType type = SampleType::uint8;  // the widest of the channels
  // What the file's samples are made to mean while they are read: 1 − sample where white is 0, and
  // a factor.
  bool isWhiteZero = false;
  float factor = 1.0f;
  // With R, G and B where the file stores other colours.
  OIIO::ImageSpec spec;
  std::optional<StoredColors> otherColors;
  int storedChannels = 0;

  // The size of the picture upright.
  int width() const { return swapsSides(orientation) ? window.height() : window.width(); }
  int height() const { return swapsSides(orientation) ? window.width() : window.height(); }
  // -1 if there is none of that name.
  int channelIndex(std::string_view channelName) const;
  // Precondition: the index of a channel.
  SampleType channelType(int channel) const;
};

// What rows of the part are read as: samples of 8 or 16 bits as they are, else floats.
OIIO::TypeDesc rowType(const ImagePart& part);

// Hears the rows [y0, y1) of what is stored once they are read, all stored channels beside each
// other. May be empty.
using RowsSeen = std::function<void(std::span<const std::byte> rows, int y0, int y1)>;

class ImageReader {
 public:
  static Result<ImageReader> open(const std::filesystem::path& path, const JobContext& context);

  const std::string& place() const { return place_; }
  ImageFileKind kind() const { return kind_; }
  // More than 1 only for OpenEXR; further pages of a TIFF and frames of a WebP are not looked at.
  int partCount() const { return partCount_; }
  // Checked against the limits above. Precondition: index in [0, partCount()).
  Result<ImagePart> part(int index);
  // Takes what is stored outside of the display window into the picture. Fails if that becomes too
  // large.
  Status includeOverscan(ImagePart& part) const;
  // Whether there are pages or frames of an animation after the first, which are not read.
  bool hasFurtherPages();

  // The chosen channels of a part, each a plane of the picture's size, upright.
  Result<std::vector<Plane>> read(const ImagePart& part, std::span<const int> channels,
                                  PixelFormat format, const std::shared_ptr<TileStore>& store,
                                  const JobContext& context, const RowsSeen& seen = {});

  // Rows [y0, y1) of what is stored, all stored channels beside each other. Precondition: of a
  // tiled file whole rows of tiles.
  Status readRows(const ImagePart& part, int y0, int y1, std::byte* rows);

  // Smaller versions of a part count, too: level 0 is the part itself.
  int levelCount(int part);
  // Precondition: level in [0, levelCount(part)).
  OIIO::ImageSpec levelSpec(int part, int level);
  // Rows [y0, y1) of the file's own coordinates, all channels in their own types.
  Status readNative(int part, int level, int y0, int y1, std::vector<std::byte>& rows);

 private:
  ImageReader() = default;

  struct Chunks;
  Result<Chunks> divide(const ImagePart& part) const;
  Result<std::vector<Plane>> readStored(const ImagePart& part, std::span<const int> channels,
                                        PixelFormat format, const std::shared_ptr<TileStore>& store,
                                        const JobContext& context, const RowsSeen& seen);
  // As the file says; OpenEXR has none.
  Orientation orientationIn(const OIIO::ImageSpec& spec) const;
  Status openInput(OIIO::ImageSpec& spec, OIIO::ImageSpec& hints);
  Error damaged(const std::string& reason) const;

  std::string place_;
  ImageFileKind kind_ = ImageFileKind::png;
  int partCount_ = 1;
  // Outlives the input, which may have something to say when it is closed, too.
  std::shared_ptr<const LibrarySilence> silence_ = std::make_shared<const LibrarySilence>();
  OIIO::ImageInput::unique_ptr input_;
};

}  // namespace cutis
