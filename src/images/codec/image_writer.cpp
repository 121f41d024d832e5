#include "src/images/codec/image_writer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/half.h"
#include "core/base/parallel.h"
#include "src/files/system/error_stream.h"
#include "src/images/codec/oiio_text.h"
#include "src/images/pixels/alpha.h"

namespace cutis {
namespace {

constexpr std::int64_t kWriteBytes = std::int64_t{8} << 20;  // between two looks at the stop token
constexpr int kBlockRows = 32;                               // of the compressors
constexpr std::int64_t kPngHeadBytes = 33;                   // the signature and IHDR
constexpr std::int64_t kJpegHeadBytes = 20;                  // SOI and JFIF's APP0

class Writer {
 public:
  Writer(const std::filesystem::path& file, const std::string& place, ImageFileKind kind,
         SampleType type, const std::string& inserted)
      : file_(file), place_(place), kind_(kind), type_(type), inserted_(inserted) {}

  Status open(const std::vector<OIIO::ImageSpec>& specs) {
    specs_ = specs;
    output_.reset();
    // TIFF rereads what it wrote to add the EXIF block, and reports a full disk by itself.
    sink_ = kind_ == ImageFileKind::tiff ? nullptr : std::make_unique<OutputFile>(file_);
    if (kind_ == ImageFileKind::png) sink_->insert(kPngHeadBytes, inserted_);
    if (kind_ == ImageFileKind::jpeg) sink_->insert(kJpegHeadBytes, inserted_);
    output_ = OIIO::ImageOutput::create(std::string(imageFormat(kind_).libraryName), sink_.get());
    if (!output_) return refused("this build of OpenImageIO does not write the format");
    const bool opened =
        specs.size() == 1
            ? output_->open(file_.string(), specs.front())
            : output_->open(file_.string(), static_cast<int>(specs.size()), specs.data());
    return opened ? state() : refused(output_->geterror());
  }

  Status nextPart(std::size_t index) {
    if (index == 0) return {};
    const bool opened =
        output_->open(file_.string(), specs_[index], OIIO::ImageOutput::AppendSubimage);
    return opened ? state() : refused(output_->geterror());
  }

  Status nextLevel(const OIIO::ImageSpec& level) {
    const bool opened = output_->open(file_.string(), level, OIIO::ImageOutput::AppendMIPLevel);
    return opened ? state() : refused(output_->geterror());
  }

  Status nativeRows(const OIIO::ImageSpec& spec, int y0, int y1, const void* samples) {
    const bool written = spec.tile_width > 0
                             ? output_->write_tiles(spec.x, spec.x + spec.width, y0, y1, 0, 1,
                                                    OIIO::TypeUnknown, samples)
                             : output_->write_scanlines(y0, y1, 0, OIIO::TypeUnknown, samples);
    return written ? state() : refused(output_->geterror());
  }

  Status rows(int y0, int y1, const void* samples) {
    const bool written = output_->write_scanlines(y0, y1, 0, oiioType(type_), samples);
    return written ? state() : refused(output_->geterror());
  }

  Status close() {
    const bool closed = output_->close();
    CUTIS_CHECK(state());
    if (!closed) return refused("");
    output_.reset();
    if (sink_ && !sink_->finish()) return full();
    return {};
  }

 private:
  // PNG and TIFF report a full disk only here.
  Status state() {
    const std::string message = output_->geterror();
    if (sink_ && sink_->failed()) return full();
    if (!message.empty()) return refused(message);
    return {};
  }

  Error full() const {
    return resourceError(place_, "the file cannot be written; free some space on the disk");
  }
  Error refused(const std::string& message) const {
    return resourceError(place_, "the file cannot be written (" +
                                     oiioReason(message, file_.string()) +
                                     "); free some space on the disk or write elsewhere");
  }

  std::filesystem::path file_;
  std::string place_;
  ImageFileKind kind_;
  SampleType type_;
  std::string inserted_;
  std::vector<OIIO::ImageSpec> specs_;
  std::unique_ptr<OutputFile> sink_;  // outlives output_
  OIIO::ImageOutput::unique_ptr output_;
};

// The largest value that becomes a sample without being cut off, and the least.
struct SampleLimits {
  float least = -std::numeric_limits<float>::infinity();
  float most = std::numeric_limits<float>::infinity();

  bool cutOff(float value) const { return value < least || value > most; }
};

SampleLimits limitsOf(SampleType type) {
  // Half a step beyond both ends still rounds to them.
  if (type == SampleType::uint8) return {-0.5f / 255.0f, 1.0f + 0.5f / 255.0f};
  if (type == SampleType::uint16) return {-0.5f / 65535.0f, 1.0f + 0.5f / 65535.0f};
  if (type != SampleType::half) return {};
  constexpr float kLargestRoundedToHalf = 65520.0f;
  return {-kLargestRoundedToHalf, kLargestRoundedToHalf};
}

// Rows of all channels, interleaved in the type of the file.
class WrittenRows {
 public:
  WrittenRows(const OutputPart& part, SampleType type) : part_(part), type_(type) {}

  int rows() const {
    const std::int64_t fits = kWriteBytes / std::max<std::int64_t>(1, rowBytes());
    return std::clamp(static_cast<int>(fits) / kBlockRows * kBlockRows, kBlockRows,
                      Plane::kTileSize);
  }

  Status fill(int y0, int y1, const JobContext& context) {
    const Rect rect = {0, y0, part_.spec.width, y1};
    bytes_.resize(static_cast<std::size_t>(rowBytes() * (y1 - y0)));
    alpha_.resize(part_.alphaStep == AlphaStep::none ? 0 : rect.pixelCount());
    if (!alpha_.empty()) CUTIS_CHECK(part_.alpha.load(rect, alpha_));
    std::vector<std::vector<char>> marks(part_.channels.size());
    CUTIS_CHECK(parallelFor(marks.size(), {context.stop, {}, {}}, [&](std::size_t c) -> Status {
      std::vector<float> values(rect.pixelCount());
      CUTIS_CHECK(part_.channels[c].load(rect, values));
      if (c < part_.colorCount) changeByAlpha(values);
      marks[c] = marksOf(values, c < part_.colorCount);
      scatter(values, c);
      return {};
    }));
    count(marks, rect.pixelCount());
    return {};
  }

  const WriteLosses& losses() const { return losses_; }

  const void* samples() const { return bytes_.data(); }

 private:
  enum Mark : char { kClipped = 1, kHidden = 2, kNoNumber = 4 };

  void changeByAlpha(std::span<float> values) const {
    if (part_.alphaStep == AlphaStep::multiply) multiplyByAlpha(values, alpha_);
    if (part_.alphaStep == AlphaStep::divide) divideByAlpha(values, alpha_);
  }

  std::vector<char> marksOf(std::span<const float> values, bool isColor) const {
    const SampleLimits limits = limitsOf(type_);
    const bool multiplied = isColor && part_.alphaStep == AlphaStep::multiply;
    std::vector<char> marks(values.size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      // Infinities are no more than infinite in a half.
      if (limits.cutOff(values[i]) && (isInteger(type_) || std::isfinite(values[i]))) {
        marks[i] |= kClipped;
      }
      if (isInteger(type_) && std::isnan(values[i])) marks[i] |= kNoNumber;
      if (multiplied && alpha_[i] == 0.0f && values[i] != 0.0f) marks[i] |= kHidden;
    }
    return marks;
  }

  // A pixel counts once, however many of its channels are marked.
  void count(const std::vector<std::vector<char>>& marks, std::size_t pixels) {
    for (std::size_t i = 0; i < pixels; ++i) {
      char all = 0;
      for (const std::vector<char>& channel : marks)
        all |= channel[i];
      losses_.clipped += (all & kClipped) != 0 ? 1 : 0;
      losses_.noNumbers += (all & kNoNumber) != 0 ? 1 : 0;
      losses_.hiddenColors += (all & kHidden) != 0 ? 1 : 0;
    }
  }

  std::int64_t rowBytes() const {
    return static_cast<std::int64_t>(part_.spec.width) * part_.spec.nchannels *
           static_cast<std::int64_t>(oiioType(type_).size());
  }

  void scatter(std::span<const float> values, std::size_t channel) {
    const std::size_t stride = part_.channels.size();
    if (type_ == SampleType::uint8) {
      scatterSamples(values, reinterpret_cast<std::uint8_t*>(bytes_.data()) + channel, stride);
    } else if (type_ == SampleType::uint16) {
      scatterSamples(values, reinterpret_cast<std::uint16_t*>(bytes_.data()) + channel, stride);
    } else if (type_ == SampleType::half) {
      std::vector<std::uint16_t> halves(values.size());
      convertFloatToHalf(values, halves);
      auto* to = reinterpret_cast<std::uint16_t*>(bytes_.data()) + channel;
      for (std::size_t i = 0; i < halves.size(); ++i)
        to[i * stride] = halves[i];
    } else {
      scatterSamples(values, reinterpret_cast<float*>(bytes_.data()) + channel, stride);
    }
  }

  const OutputPart& part_;
  SampleType type_;
  std::vector<std::byte> bytes_;
  std::vector<float> alpha_;
  WriteLosses losses_;
};

// Rows that are taken at once: whole tiles, and bands that fit into memory.
int nativeStep(const OIIO::ImageSpec& spec) {
  if (spec.tile_width > 0) return spec.tile_height;
  const auto rowBytes = static_cast<std::int64_t>(spec.scanline_bytes(true));
  const std::int64_t fits = kWriteBytes / std::max<std::int64_t>(1, rowBytes);
  return std::clamp(static_cast<int>(fits) / kBlockRows * kBlockRows, kBlockRows, Plane::kTileSize);
}

Status writeNativeLevel(Writer& writer, const OutputPart& part, int level,
                        const JobContext& context) {
  const OIIO::ImageSpec& spec =
      level == 0 ? part.spec : part.levels[static_cast<std::size_t>(level - 1)];
  const int end = spec.y + spec.height;
  std::vector<std::byte> rows;
  for (int y = spec.y; y < end; y += nativeStep(spec)) {
    if (context.stopRequested()) return Cancelled{};
    const int next = std::min(end, y + nativeStep(spec));
    CUTIS_CHECK(part.nativeRows(level, y, next, rows));
    CUTIS_CHECK(writer.nativeRows(spec, y, next, rows.data()));
    if (level == 0) context.progress.report(static_cast<double>(next - spec.y) / spec.height);
  }
  return {};
}

Status writeNative(Writer& writer, const OutputPart& part, const JobContext& context) {
  CUTIS_CHECK(writeNativeLevel(writer, part, 0, context));
  for (std::size_t k = 0; k < part.levels.size(); ++k) {
    CUTIS_CHECK(writer.nextLevel(part.levels[k]));
    CUTIS_CHECK(writeNativeLevel(writer, part, static_cast<int>(k) + 1, context));
  }
  return {};
}

Status openWithMetadata(Writer& writer, const std::vector<OutputPart>& parts,
                        const std::vector<OIIO::ImageSpec>& plain, const std::string& place,
                        const JobContext& context) {
  std::vector<OIIO::ImageSpec> specs;
  for (const OutputPart& part : parts)
    specs.push_back(part.spec);
  Status opened;
  try {
    opened = writer.open(specs);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    opened = resourceError(place, error.what());
  }
  if (opened) return opened;
  if (!writer.open(plain)) return opened;
  context.say(place + ": the source's metadata cannot be kept in this format and is left out");
  return {};
}

}  // namespace

Result<WriteLosses> writeParts(const std::filesystem::path& file, const std::string& place,
                               ImageFileKind kind, SampleType type,
                               const std::vector<OutputPart>& parts,
                               const std::vector<OIIO::ImageSpec>& plain,
                               const std::string& inserted, const JobContext& context) try {
  setUpOpenImageIO();
  const LibrarySilence silence;
  Writer writer(file, place, kind, type, inserted);
  CUTIS_CHECK(openWithMetadata(writer, parts, plain, place, context));
  WriteLosses losses;
  std::int64_t totalRows = 0, doneRows = 0;
  for (const OutputPart& part : parts)
    totalRows += part.spec.height;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    CUTIS_CHECK(writer.nextPart(i));
    if (parts[i].nativeRows) {
      const auto share = [&](std::size_t k) {
        return static_cast<double>(k) / static_cast<double>(parts.size());
      };
      CUTIS_CHECK(writeNative(writer, parts[i], context.child(share(i), share(i + 1))));
      continue;
    }
    WrittenRows band(parts[i], type);
    const int height = parts[i].spec.height;
    for (int y = 0; y < height; y += band.rows()) {
      if (context.stopRequested()) return Cancelled{};
      const int end = std::min(height, y + band.rows());
      CUTIS_CHECK(band.fill(y, end, context));
      CUTIS_CHECK(writer.rows(y, end, band.samples()));
      doneRows += end - y;
      context.progress.report(static_cast<double>(doneRows) / static_cast<double>(totalRows));
    }
    losses.clipped += band.losses().clipped;
    losses.noNumbers += band.losses().noNumbers;
    losses.hiddenColors += band.losses().hiddenColors;
  }
  CUTIS_CHECK(writer.close());
  return losses;
} catch (const std::bad_alloc&) {
  return resourceError(place, "not enough memory to write the image; close other programs");
} catch (const std::exception& error) {
  return resourceError(place, "the file cannot be written (" + oiioReason(error.what(), place) +
                                  "); free some space on the disk or write elsewhere");
}

}  // namespace cutis
