#pragma once

// Pictures in files.
//
// The formats that are read and written, with their sample types: src/images/codec/image_formats.h.
// What is read is recognised by its content and not by its name.
//
// Values: unsigned integers are value / maximum in [0, 1], without linearisation; floats as they
// are, with NaN, infinities and negatives. Alpha stays as it is stored and multiplies nothing.
// Integers are written clamped and rounded without dithering, NaN as 0; half holds ±65504, beyond
// is infinite. Pixels are in the order of the file; an EXIF orientation stays metadata. A picture
// of an OpenEXR file is its display window, 0 where nothing is stored; of several parts the first
// counts.
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
#include "src/images/codec/metadata.h"
#include "src/images/codec/sample_type.h"
#include "src/images/color/color_statement.h"

namespace cutis {

struct ImageHeader {
  int width = 0;
  int height = 0;
  // "R", "G", "B", "A", "Y" or whatever the file calls them.
  std::vector<std::string> channelNames;
  SampleType sourceType = SampleType::uint8;  // the widest of the channels
  // What the file says; may be empty, and a name nobody knows.
  std::string colorSpace;
  // All that it says of its colours.
  FileColors colors;
  ImageMetadata metadata;

  // -1 if there is none of that name.
  int channelIndex(std::string_view name) const;
};

struct Image : ImageHeader {
  std::vector<Plane> channels;  // one per name, all of one size
  // ContentHash of the file.
  std::string contentHash;
};

Result<ImageHeader> readImageHeader(const std::filesystem::path& path, const JobContext& context);

struct ImageReadOptions {
  // Of the planes; none: what holds the file's samples without loss, half for halves and else
  // float. A half plane holds 8 bits well enough for display only: v / 255 is not a half.
  std::optional<PixelFormat> format = {};
  // Looks at the header before any pixel is read; what it objects to is the reader's error. May be
  // empty.
  std::function<Status(const ImageHeader& header)> accept = {};
};

Result<Image> readImage(const std::filesystem::path& path, const ImageReadOptions& options,
                        const std::shared_ptr<TileStore>& store, const JobContext& context);

struct ImageContent {
  std::vector<std::string> channelNames;
  std::vector<Plane> channels;  // one per name, all of one size, at least one
  // Canonical name (src/color); empty says nothing about the colours.
  std::string colorSpace;
  ImageMetadata metadata;
  // The pixels are still in the space of the metadata's colour profile.
  bool keepColorProfile = false;
};

// What the format of this name can hold, the most usual first. A usage error for other formats.
Result<std::vector<SampleType>> writableSampleTypes(const std::filesystem::path& path);
// Whether this could be written, found out before any work is done: format, sample type, folder.
Status checkImageOutput(const std::filesystem::path& path, SampleType type);

// Replaces the file as a whole or leaves it as it was. Channels the format has no place for are
// left out with a notice.
Status writeImage(const std::filesystem::path& path, const ImageContent& content, SampleType type,
                  const JobContext& context);

}  // namespace cutis
