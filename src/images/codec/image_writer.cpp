#include "src/images/codec/image_writer.h"

#include <algorithm>

#include "core/base/half.h"
#include "core/base/parallel.h"
#include "src/files/io/error_stream.h"
#include "src/images/codec/oiio_text.h"

namespace cutis {
namespace {

constexpr std::int64_t kWriteBytes = std::int64_t{8} << 20;  // between two looks at the stop token
constexpr int kBlockRows = 32;                               // of the compressors

class Writer {
 public:
  Writer(const std::filesystem::path& file, const std::string& place, ImageFileKind kind,
         SampleType type)
      : file_(file), place_(place), kind_(kind), type_(type) {}

  Status open(const std::vector<OIIO::ImageSpec>& specs) {
    specs_ = specs;
    output_.reset();
    // TIFF rereads what it wrote to add the EXIF block, and reports a full disk by itself.
    sink_ = kind_ == ImageFileKind::tiff ? nullptr : std::make_unique<OutputFile>(file_);
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
  std::vector<OIIO::ImageSpec> specs_;
  std::unique_ptr<OutputFile> sink_;  // outlives output_
  OIIO::ImageOutput::unique_ptr output_;
};

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
    bytes_.resize(static_cast<std::size_t>(rowBytes() * (y1 - y0)));
    return parallelFor(part_.channels.size(), {context.stop, {}, {}}, [&](std::size_t c) -> Status {
      const Rect rect = {0, y0, part_.spec.width, y1};
      std::vector<float> values(rect.pixelCount());
      CUTIS_CHECK(part_.channels[c].load(rect, values));
      scatter(values, c);
      return {};
    });
  }

  const void* samples() const { return bytes_.data(); }

 private:
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
};

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

Status writeParts(const std::filesystem::path& file, const std::string& place, ImageFileKind kind,
                  SampleType type, const std::vector<OutputPart>& parts,
                  const std::vector<OIIO::ImageSpec>& plain, const JobContext& context) try {
  setUpOpenImageIO();
  const LibrarySilence silence;
  Writer writer(file, place, kind, type);
  CUTIS_CHECK(openWithMetadata(writer, parts, plain, place, context));
  std::int64_t totalRows = 0, doneRows = 0;
  for (const OutputPart& part : parts)
    totalRows += part.spec.height;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    CUTIS_CHECK(writer.nextPart(i));
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
  }
  return writer.close();
} catch (const std::bad_alloc&) {
  return resourceError(place, "not enough memory to write the image; close other programs");
} catch (const std::exception& error) {
  return resourceError(place, "the file cannot be written (" + oiioReason(error.what(), place) +
                                  "); free some space on the disk or write elsewhere");
}

}  // namespace cutis
