#include "src/images/codec/image_reader.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>

#include "core/base/echoed_text.h"
#include "core/base/parallel.h"
#include "src/images/codec/layout_check.h"
#include "src/images/codec/oiio_text.h"
#include "src/images/codec/sample_meaning.h"
#include "src/images/inputs/exif_directories.h"
#include "src/images/inputs/ink_jpeg_input.h"
#include "src/images/inputs/luma_chroma_input.h"
#include "src/images/inputs/png_check.h"
#include "src/images/inputs/radiance_header.h"
#include "src/images/inputs/tiff_check.h"
#include "src/images/inputs/webp_chunks.h"

namespace cutis {
namespace {

constexpr std::int64_t kReadBytes = std::int64_t{8} << 20;   // between two looks at the stop token
constexpr std::int64_t kChunkBytes = std::int64_t{1} << 30;  // in memory at once
constexpr int kTargaMultiplied = 4;  // attributes type of the extension area
constexpr char kRadianceRgbe[] = "32-bit_rle_rgbe";

std::optional<SampleType> sampleTypeOf(OIIO::TypeDesc type) {
  switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
      return SampleType::uint8;
    case OIIO::TypeDesc::UINT16:
      return SampleType::uint16;
    case OIIO::TypeDesc::UINT32:
      return SampleType::uint32;
    case OIIO::TypeDesc::HALF:
      return SampleType::half;
    case OIIO::TypeDesc::FLOAT:
      return SampleType::float32;
    case OIIO::TypeDesc::DOUBLE:
      return SampleType::float64;
    default:
      return std::nullopt;
  }
}

// libjpeg also complains about what does no harm to the picture; some cameras write such files.
bool isHarmless(ImageFileKind kind, const std::string& message) {
  return kind == ImageFileKind::jpeg &&
         (message.find("extraneous bytes") != std::string::npos ||
          message.find("Invalid SOS parameters") != std::string::npos);
}

// The channels as they are once they are converted.
void nameConverted(ImagePart& part) {
  auto& names = part.spec.channelnames;
  names.erase(names.begin(), names.begin() + part.otherColors->channels);
  names.insert(names.begin(), {"R", "G", "B"});
  part.spec.nchannels = static_cast<int>(names.size());
  part.spec.channelformats.clear();
  const int left = part.otherColors->channels - 3;
  if (part.spec.alpha_channel >= 0) part.spec.alpha_channel -= left;
}

// Whether OpenImageIO, asked to leave colours as they are stored, hands them over multiplied by
// alpha.
AlphaKind alphaKindOf(ImageFileKind kind, const OIIO::ImageSpec& spec) {
  if (spec.alpha_channel < 0 && kind != ImageFileKind::openExr) return AlphaKind::straight;
  if (spec.get_int_attribute("oiio:UnassociatedAlpha") != 0) return AlphaKind::straight;
  // The reader of Targa files says so only where the file itself calls its alpha useful.
  if (kind == ImageFileKind::targa)
    return spec.get_int_attribute("targa:alpha_type") == kTargaMultiplied ? AlphaKind::associated
                                                                          : AlphaKind::straight;
  // The reader of BMP divides nothing, and writers of BMP do not multiply. That of Photoshop files
  // does as it is asked and does not say so.
  const bool isStraight = kind == ImageFileKind::bmp || kind == ImageFileKind::psd;
  return isStraight ? AlphaKind::straight : AlphaKind::associated;
}

Error noMemory(const std::string& place) {
  return resourceError(place, "not enough memory for the image; use a smaller one");
}

Rect rectOf(int x, int y, int width, int height) {
  return {x, y, x + width, y + height};
}

}  // namespace

int ImagePart::channelIndex(std::string_view channelName) const {
  const auto found = std::find(spec.channelnames.begin(), spec.channelnames.end(), channelName);
  return found == spec.channelnames.end() ? -1
                                          : static_cast<int>(found - spec.channelnames.begin());
}

OIIO::TypeDesc rowType(const ImagePart& part) {
  const bool uniform = part.spec.channelformats.empty();
  if (uniform && part.type == SampleType::uint8) return OIIO::TypeUInt8;
  if (uniform && part.type == SampleType::uint16) return OIIO::TypeUInt16;
  return OIIO::TypeFloat;
}

SampleType ImagePart::channelType(int channel) const {
  return sampleTypeOf(spec.channelformat(channel)).value_or(type);
}

// Rows are decoded in steps and passed on in chunks of several steps. Steps of a tiled file are
// rows of tiles.
struct ImageReader::Chunks {
  int rowsPerStep = 1;
  int rowsPerChunk = 1;  // a multiple of rowsPerStep
  std::size_t rowBytes = 0;
};

Error ImageReader::damaged(const std::string& reason) const {
  return readingError(reason, std::string(imageFormat(kind_).name), place_);
}

Result<ImageReader> ImageReader::open(const std::filesystem::path& path,
                                      const JobContext& context) {
  CUTIS_TRY(kind, identifyImageFile(path));
  if (kind == ImageFileKind::png) {
    CUTIS_CHECK(checkPngChunks(path, PngExtent::beforePixels, context));
  }
  setUpOpenImageIO();
  ImageReader reader;
  reader.place_ = path.string();
  reader.kind_ = kind;
  try {
    reader.input_ = OIIO::ImageInput::create(std::string(imageFormat(kind).libraryName));
    if (!reader.input_) {
      return inputError(reader.place_, std::string(imageFormat(kind).name) +
                                           " files cannot be read by this build of OpenImageIO; "
                                           "convert the file");
    }
    OIIO::ImageSpec hints, spec;
    hints.attribute("oiio:UnassociatedAlpha", 1);  // leave colours as they are stored
    CUTIS_CHECK(reader.openInput(spec, hints));
    reader.input_->geterror();  // what did not keep it from opening
    if (kind == ImageFileKind::openExr) {
      reader.partCount_ = std::max(1, spec.get_int_attribute("oiio:subimages", 1));
    }
  } catch (const std::bad_alloc&) {
    return noMemory(reader.place_);
  } catch (const std::exception& error) {
    return reader.damaged(error.what());
  }
  if (reader.partCount_ > kMostParts) {
    return inputError(reader.place_, "the file has " + std::to_string(reader.partCount_) +
                                         " parts; at most " + std::to_string(kMostParts) +
                                         " are read");
  }
  return reader;
}

// With the pixels as they are stored where OpenImageIO would change their colours or not read them.
// An input of our own takes over what that needs.
Status ImageReader::openInput(OIIO::ImageSpec& spec, OIIO::ImageSpec& hints) {
  const bool opened = input_->open(place_, spec, hints);
  const std::string reason = opened ? std::string() : input_->geterror();
  if (kind_ == ImageFileKind::tiff && (!opened || needsRawColors(kind_, spec))) {
    hints.attribute("oiio:RawColor", 1);
    input_->close();
    if (input_->open(place_, spec, hints)) return {};
  }
  if (kind_ == ImageFileKind::openExr && opened && isWholeLumaChroma(spec)) {
    return inputError(place_,
                      "OpenEXR files of luminance and chroma at full resolution are not "
                      "supported; save it as RGB");
  }
  if (kind_ == ImageFileKind::openExr && reason.find("Subsampled") != std::string::npos) {
    auto input = openLumaChroma(place_);
    if (input && input->open(place_, spec)) {
      input_ = std::move(input);
      return {};
    }
  }
  if (opened && kind_ == ImageFileKind::jpeg && isInkJpeg(spec)) {
    input_ = openInkJpeg(place_, spec);
    if (!input_->open(place_, spec)) return damaged(input_->geterror());
    return {};
  }
  if (opened) return {};
  if (kind_ == ImageFileKind::radiance) {
    const std::string format = readRadianceHeader(place_).format;
    if (!format.empty() && format != kRadianceRgbe)
      return inputError(place_, "Radiance HDR files with samples of the format '" +
                                    shortened(format) +
                                    "' are not supported; save it as RGBE or as OpenEXR");
  }
  return damaged(reason);
}

Result<ImagePart> ImageReader::part(int index) try {
  ImagePart part;
  part.index = index;
  part.spec = input_->spec(index, 0);
  if (part.spec.format == OIIO::TypeUnknown) return damaged(input_->geterror());
  nameUndeclared(kind_, part.spec);
  const OIIO::ImageSpec& spec = part.spec;
  CUTIS_CHECK(checkLayout(spec, place_));
  const auto type = sampleTypeOf(spec.format);
  if (!type) {
    return inputError(place_, std::string("samples of type ") + spec.format.c_str() +
                                  " are not supported; convert to 8 or 16 bit, half or float");
  }
  if (isLogLuv(kind_, spec)) {
    return inputError(place_, "SGI LogLuv TIFF files are not supported; save it as OpenEXR");
  }
  part.type = *type;
  part.isWhiteZero = hasWhiteAtZero(kind_, spec);
  if (kind_ == ImageFileKind::radiance)
    part.factor = static_cast<float>(1.0 / readRadianceHeader(place_).exposure);
  part.storedChannels = spec.nchannels;
  part.otherColors = storedColorsOf(kind_, spec, place_);
  if (part.otherColors && part.otherColors->toLinearRec709) nameConverted(part);
  part.name = std::string(spec.get_string_attribute("oiio:subimagename"));
  part.stored = rectOf(spec.x, spec.y, spec.width, spec.height);
  part.window = part.stored;
  if (kind_ == ImageFileKind::openExr && spec.full_width > 0 && spec.full_height > 0) {
    part.window = rectOf(spec.full_x, spec.full_y, spec.full_width, spec.full_height);
  }
  part.orientation = orientationIn(spec);
  part.alphaKind = alphaKindOf(kind_, spec);
  return part;
} catch (const std::bad_alloc&) {
  return noMemory(place_);
} catch (const std::exception& error) {
  return damaged(error.what());
}

Orientation ImageReader::orientationIn(const OIIO::ImageSpec& spec) const {
  if (kind_ == ImageFileKind::openExr) return Orientation::upright;
  if (kind_ == ImageFileKind::webP) {
    return orientationOf(exifOrientation(readWebPChunks(place_).exif));
  }
  return orientationOf(spec.get_int_attribute("Orientation", 1));
}

Status ImageReader::includeOverscan(ImagePart& part) const {
  const Rect &shown = part.window, &stored = part.stored;
  const Rect both = {std::min(shown.x0, stored.x0), std::min(shown.y0, stored.y0),
                     std::max(shown.x1, stored.x1), std::max(shown.y1, stored.y1)};
  if (exceedsLimits(both.width(), both.height())) {
    return inputError(place_,
                      "the data window of the image lies too far from its display window; crop it "
                      "to what is needed");
  }
  part.window = both;
  return {};
}

int ImageReader::levelCount(int part) {
  constexpr int kMostLevels = 32;  // halve any size there is
  int count = 1;
  // Readers of other formats answer for levels that are not there.
  if (kind_ != ImageFileKind::openExr) return count;
  while (count < kMostLevels && input_->spec(part, count).format != OIIO::TypeUnknown)
    ++count;
  input_->geterror();  // that there are no more
  return count;
}

OIIO::ImageSpec ImageReader::levelSpec(int part, int level) {
  return input_->spec(part, level);
}

Status ImageReader::readNative(int part, int level, int y0, int y1,
                               std::vector<std::byte>& rows) try {
  const OIIO::ImageSpec spec = input_->spec(part, level);
  const std::size_t rowBytes = static_cast<std::size_t>(spec.width) * spec.pixel_bytes(true);
  const int tile = std::max(1, spec.tile_height);
  const int begin = y0 - (y0 - spec.y) % tile;
  const int end = std::min(spec.y + spec.height, y1 + (tile - (y1 - spec.y) % tile) % tile);
  rows.resize(static_cast<std::size_t>(end - begin) * rowBytes);
  const bool read =
      spec.tile_width > 0
          ? input_->read_tiles(part, level, spec.x, spec.x + spec.width, begin, end, 0, 1, 0,
                               spec.nchannels, OIIO::TypeUnknown, rows.data())
          : input_->read_scanlines(part, level, y0, y1, 0, 0, spec.nchannels, OIIO::TypeUnknown,
                                   rows.data());
  const std::string message = input_->geterror();
  if (!read || !message.empty()) return damaged(message);
  const auto skipped = static_cast<std::size_t>(y0 - begin) * rowBytes;
  rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(skipped));
  rows.resize(static_cast<std::size_t>(y1 - y0) * rowBytes);
  return {};
} catch (const std::bad_alloc&) {
  throw;
} catch (const std::exception& error) {
  return damaged(error.what());
}

bool ImageReader::hasFurtherPages() try {
  if (kind_ == ImageFileKind::webP) return readWebPChunks(place_).frames > 1;
  if (kind_ != ImageFileKind::tiff) return false;
  const bool found = input_->spec(1, 0).format != OIIO::TypeUnknown;
  input_->geterror();  // that there is none
  return found;
} catch (const std::exception&) {
  return false;
}

Result<ImageReader::Chunks> ImageReader::divide(const ImagePart& part) const {
  Chunks chunks;
  chunks.rowBytes = static_cast<std::size_t>(part.spec.width) *
                    static_cast<std::size_t>(part.storedChannels) * rowType(part).size();
  const auto rowBytes = static_cast<std::int64_t>(chunks.rowBytes);
  if (part.spec.tile_width > 0) {
    chunks.rowsPerStep = part.spec.tile_height;
    if (chunks.rowsPerStep <= 0 || part.spec.tile_depth > 1 ||
        std::min(chunks.rowsPerStep, part.spec.height) * rowBytes > 2 * kChunkBytes) {
      return inputError(place_, "the tiles of the image are too large; save it without tiles");
    }
  } else {
    const auto rows = std::clamp<std::int64_t>(kReadBytes / rowBytes, 1, Plane::kTileSize);
    // Compressors work on blocks of up to 32 rows.
    chunks.rowsPerStep = static_cast<int>(rows >= 32 ? rows / 32 * 32 : rows);
  }
  const std::int64_t fits = std::max<std::int64_t>(1, kChunkBytes / rowBytes);
  const auto wanted = static_cast<int>(std::min<std::int64_t>(Plane::kTileSize, fits));
  chunks.rowsPerChunk = std::max(1, wanted / chunks.rowsPerStep) * chunks.rowsPerStep;
  return chunks;
}

Status ImageReader::readRows(const ImagePart& part, int y0, int y1, std::byte* rows) try {
  const OIIO::ImageSpec& spec = part.spec;
  const bool read =
      spec.tile_width > 0
          ? input_->read_tiles(part.index, part.level, spec.x, spec.x + spec.width, y0, y1, 0, 1, 0,
                               part.storedChannels, rowType(part), rows)
          : input_->read_scanlines(part.index, part.level, y0, y1, 0, 0, part.storedChannels,
                                   rowType(part), rows);
  // A cut-off TIFF or JPEG reads with success; only the message says so.
  const std::string message = input_->geterror();
  if (!read || (!message.empty() && !isHarmless(kind_, message))) return damaged(message);
  giveMeaning(part, rows,
              static_cast<std::size_t>(y1 - y0) * static_cast<std::size_t>(spec.width) *
                  static_cast<std::size_t>(part.storedChannels));
  return {};
} catch (const std::bad_alloc&) {
  return noMemory(place_);
} catch (const std::exception& error) {
  return damaged(error.what());
}

namespace {

// One channel of interleaved rows into a plane of the picture's window.
template <typename Sample>
Status storeChannel(const ImagePart& part, const std::byte* rows, const Rect& chunk, int channel,
                    Plane& plane) {
  const Rect seen = intersection(chunk, part.window);
  if (seen.empty()) return {};
  const auto channels = static_cast<std::size_t>(part.storedChannels);
  const auto width = static_cast<std::size_t>(seen.width());
  std::vector<float> values(seen.pixelCount());
  for (int y = seen.y0; y < seen.y1; ++y) {
    const std::size_t pixel =
        static_cast<std::size_t>(y - chunk.y0) * static_cast<std::size_t>(chunk.width()) +
        static_cast<std::size_t>(seen.x0 - chunk.x0);
    const auto* samples = reinterpret_cast<const Sample*>(rows) + pixel * channels +
                          static_cast<std::size_t>(channel);
    gatherSamples(samples, channels,
                  std::span(values).subspan(static_cast<std::size_t>(y - seen.y0) * width, width));
  }
  const Rect &window = part.window, target = {seen.x0 - window.x0, seen.y0 - window.y0,
                                              seen.x1 - window.x0, seen.y1 - window.y0};
  if (part.orientation == Orientation::upright) return plane.store(target, values);
  std::vector<float> upright(values.size());
  turnUpright(values, seen.width(), seen.height(), part.orientation, upright);
  return plane.store(uprightRect(target, window.width(), window.height(), part.orientation),
                     upright);
}

Status storeChunk(const ImagePart& part, const std::byte* rows, const Rect& chunk,
                  std::span<const int> channels, std::vector<Plane>& planes,
                  const JobContext& context) {
  const OIIO::TypeDesc type = rowType(part);
  return parallelFor(planes.size(), {context.stop, {}, {}}, [&](std::size_t i) -> Status {
    if (type == OIIO::TypeUInt8) {
      return storeChannel<std::uint8_t>(part, rows, chunk, channels[i], planes[i]);
    }
    if (type == OIIO::TypeUInt16) {
      return storeChannel<std::uint16_t>(part, rows, chunk, channels[i], planes[i]);
    }
    return storeChannel<float>(part, rows, chunk, channels[i], planes[i]);
  });
}

}  // namespace

Result<std::vector<Plane>> ImageReader::read(const ImagePart& part, std::span<const int> channels,
                                             PixelFormat format,
                                             const std::shared_ptr<TileStore>& store,
                                             const JobContext& context, const RowsSeen& seen) {
  if (!part.otherColors || !part.otherColors->toLinearRec709)
    return readStored(part, channels, format, store, context, seen);
  std::vector<int> all(static_cast<std::size_t>(part.storedChannels));
  std::iota(all.begin(), all.end(), 0);
  CUTIS_TRY(stored, readStored(part, all, PixelFormat::float32, store, context, seen));
  CUTIS_TRY(converted, convertColors(*part.otherColors, std::move(stored), store, context));
  std::vector<Plane> planes;
  for (const int channel : channels)
    planes.push_back(converted[static_cast<std::size_t>(channel)]);
  return planes;
}

Result<std::vector<Plane>> ImageReader::readStored(
    const ImagePart& part, std::span<const int> channels, PixelFormat format,
    const std::shared_ptr<TileStore>& store, const JobContext& context, const RowsSeen& seen) try {
  if (kind_ == ImageFileKind::png) {
    CUTIS_CHECK(checkPngChunks(place_, PngExtent::whole, context));
  }
  if (kind_ == ImageFileKind::tiff) CUTIS_CHECK(checkTiffExtent(place_));
  CUTIS_TRY(chunks, divide(part));
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    planes.emplace_back(part.width(), part.height(), format, store);
  }
  const Rect& stored = part.stored;
  const auto chunkRows = static_cast<std::size_t>(std::min(chunks.rowsPerChunk, stored.height()));
  std::vector<std::byte> buffer(chunkRows * chunks.rowBytes);
  for (int y0 = stored.y0; y0 < stored.y1; y0 += chunks.rowsPerChunk) {
    const int y1 = std::min(stored.y1, y0 + chunks.rowsPerChunk);
    for (int y = y0; y < y1; y += chunks.rowsPerStep) {
      if (context.stopRequested()) return Cancelled{};
      const std::size_t offset = static_cast<std::size_t>(y - y0) * chunks.rowBytes;
      CUTIS_CHECK(readRows(part, y, std::min(y1, y + chunks.rowsPerStep), buffer.data() + offset));
    }
    if (seen) {
      const std::size_t bytes = static_cast<std::size_t>(y1 - y0) * chunks.rowBytes;
      seen(std::span(buffer).first(bytes), y0, y1);
    }
    CUTIS_CHECK(
        storeChunk(part, buffer.data(), {stored.x0, y0, stored.x1, y1}, channels, planes, context));
    context.progress.report(static_cast<double>(y1 - stored.y0) / stored.height());
  }
  return planes;
} catch (const std::bad_alloc&) {
  return noMemory(place_);
}

}  // namespace cutis
