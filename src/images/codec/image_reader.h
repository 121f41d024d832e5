#pragma once

// An open picture file, part by part, without trust in what it says. For the files of this folder.
//
// Everything OpenImageIO throws or reports ends up as one sentence that names the file. Memory is
// bounded by bands of rows, whatever the header asks for. Not thread-safe.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "src/files/io/error_stream.h"
#include "src/images/codec/sample_type.h"
#include "src/images/codec/source_file.h"

namespace cutis {

// Larger pictures are taken for damaged or hostile files.
inline constexpr int kLargestSide = 32768;
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 30;
inline constexpr int kMostChannels = 256;
inline constexpr int kMostParts = 64;

struct ImagePart {
  int index = 0;
  std::string name;  // of a part of a multi-part EXR
  // The picture: the display window of an EXR, else all that is stored.
  Rect window;
  // What is stored, in the same coordinates; the rest of the picture is 0.
  Rect stored;
  SampleType type = SampleType::uint8;
  OIIO::ImageSpec spec;

  int width() const { return window.width(); }
  int height() const { return window.height(); }
  // -1 if there is none of that name.
  int channelIndex(std::string_view channelName) const;
};

class ImageReader {
 public:
  static Result<ImageReader> open(const std::filesystem::path& path, const JobContext& context);

  const std::string& place() const { return place_; }
  ImageFileKind kind() const { return kind_; }
  // More than 1 only for OpenEXR; further pages of a TIFF are not looked at.
  int partCount() const { return partCount_; }
  // Checked against the limits above. Precondition: index in [0, partCount()).
  Result<ImagePart> part(int index);

  // The chosen channels of a part, each a plane of the window's size.
  Result<std::vector<Plane>> read(const ImagePart& part, std::span<const int> channels,
                                  PixelFormat format, const std::shared_ptr<TileStore>& store,
                                  const JobContext& context);

 private:
  ImageReader() = default;

  struct Chunks;
  Result<Chunks> divide(const ImagePart& part) const;
  Status readRows(const ImagePart& part, int y0, int y1, std::vector<std::byte>& buffer,
                  std::size_t offset);
  Error damaged(const std::string& reason) const;

  std::string place_;
  ImageFileKind kind_ = ImageFileKind::png;
  int partCount_ = 1;
  OIIO::ImageInput::unique_ptr input_;
  std::shared_ptr<const LibrarySilence> silence_ = std::make_shared<const LibrarySilence>();
};

}  // namespace cutis
