#include "src/images/exr_edition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>

#include "core/base/half.h"
#include "core/base/word_list.h"
#include "src/images/codec/image_reader.h"
#include "src/images/codec/oiio_text.h"

namespace cutis {
namespace {

constexpr int kMipmap = 1;                // openexr:levelmode
constexpr float kLargestHalf = 65520.0f;  // and above is infinite

// What a header says of where the pixels lie and how they are stored.
constexpr std::array<std::string_view, 12> kLayoutNames = {"PixelAspectRatio",
                                                           "screenWindowCenter",
                                                           "screenWindowWidth",
                                                           "oiio:subimagename",
                                                           "name",
                                                           "view",
                                                           "multiView",
                                                           "wrapmodes",
                                                           "envmap",
                                                           "textureformat",
                                                           "openexr:roundingmode",
                                                           "openexr:levelmode"};

// Half floats to and from their bits; other types of OpenEXR are 32 bits.
float sampleAt(const std::byte* bytes, OIIO::TypeDesc type) {
  if (type == OIIO::TypeHalf) {
    std::uint16_t half = 0;
    std::memcpy(&half, bytes, sizeof half);
    float value = 0.0f;
    convertHalfToFloat(std::span(&half, 1), std::span(&value, 1));
    return value;
  }
  if (type == OIIO::TypeUInt32) {
    std::uint32_t whole = 0;
    std::memcpy(&whole, bytes, sizeof whole);
    return static_cast<float>(whole);
  }
  float value = 0.0f;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

void putSample(float value, OIIO::TypeDesc type, std::byte* bytes) {
  if (type == OIIO::TypeHalf) {
    std::uint16_t half = 0;
    convertFloatToHalf(std::span(&value, 1), std::span(&half, 1));
    std::memcpy(bytes, &half, sizeof half);
  } else {
    std::memcpy(bytes, &value, sizeof value);
  }
}

std::vector<std::size_t> channelOffsets(const OIIO::ImageSpec& spec) {
  std::vector<std::size_t> offsets = {0};
  for (int c = 0; c < spec.nchannels; ++c)
    offsets.push_back(offsets.back() + spec.channelformat(c).size());
  return offsets;
}

// How much each pixel of a level changes, one value per colour: the mean of what the pixels of the
// level above change.
class LevelChange {
 public:
  LevelChange() = default;
  LevelChange(const OIIO::ImageSpec& level)
      : width_(level.width),
        height_(level.height),
        sums_(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.0f),
        counts_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0) {}

  bool empty() const { return counts_.empty(); }

  // A pixel of the level above, which is width × height.
  void add(int x, int y, int width, int height, const std::array<float, 3>& change) {
    if (empty()) return;
    const std::size_t pixel = index(static_cast<int>(std::int64_t{x} * width_ / width),
                                    static_cast<int>(std::int64_t{y} * height_ / height));
    for (std::size_t c = 0; c < 3; ++c)
      sums_[3 * pixel + c] += std::isfinite(change[c]) ? change[c] : 0.0f;
    ++counts_[pixel];
  }

  float at(int x, int y, std::size_t color) const {
    const std::size_t pixel = index(x, y);
    return counts_[pixel] == 0 ? 0.0f
                               : sums_[3 * pixel + color] / static_cast<float>(counts_[pixel]);
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<float> sums_;
  std::vector<int> counts_;
};

// The rows of the part whose colours change.
class EditedRows {
 public:
  EditedRows(std::shared_ptr<ImageReader> reader, const ImageContent& content,
             const OIIO::ImageSpec& written, std::vector<OIIO::ImageSpec> levels,
             std::shared_ptr<std::size_t> clipped)
      : reader_(std::move(reader)),
        part_(content.source->layer.part),
        colors_(*content.source->layer.colors),
        frame_(content.source->frame),
        written_(written),
        levels_(std::move(levels)),
        clipped_(std::move(clipped)) {
    for (const int color : colors_)
      planes_.push_back(content.channels[static_cast<std::size_t>(color)]);
  }

  Status fill(int level, int y0, int y1, std::vector<std::byte>& rows) {
    const OIIO::ImageSpec source = reader_->levelSpec(part_, level);
    CUTIS_CHECK(reader_->readNative(part_, level, y0, y1, native_));
    if (y0 == source.y) startLevel(level);
    if (level == 0) CUTIS_CHECK(loadColors(source, y0, y1));
    recode(source, level, y0, y1, rows);
    return {};
  }

 private:
  void startLevel(int level) {
    change_ = std::move(nextChange_);
    const auto next = static_cast<std::size_t>(level);
    nextChange_ = next < levels_.size() ? LevelChange(levels_[next]) : LevelChange();
  }

  Status loadColors(const OIIO::ImageSpec& source, int y0, int y1) {
    const Rect rect = {source.x - frame_.originX, y0 - frame_.originY,
                       source.x + source.width - frame_.originX, y1 - frame_.originY};
    for (std::size_t c = 0; c < 3; ++c) {
      edited_[c].resize(rect.pixelCount());
      CUTIS_CHECK(planes_[c].load(rect, edited_[c]));
    }
    return {};
  }

  float changed(int level, std::size_t color, std::size_t pixel, int x, int y, float stored) const {
    if (level == 0) return edited_[color][pixel];
    const float change = change_.at(x, y, color);
    return change == 0.0f ? stored : stored + change;
  }

  void recode(const OIIO::ImageSpec& source, int level, int y0, int y1,
              std::vector<std::byte>& rows) {
    const std::vector<std::size_t> from = channelOffsets(source), to = channelOffsets(written_);
    const auto width = static_cast<std::size_t>(source.width);
    const std::size_t pixels = static_cast<std::size_t>(y1 - y0) * width;
    rows.resize(pixels * to.back());
    for (std::size_t p = 0; p < pixels; ++p) {
      const std::byte* before = native_.data() + p * from.back();
      std::byte* after = rows.data() + p * to.back();
      for (std::size_t c = 0; c + 1 < from.size(); ++c) {
        if (std::find(colors_.begin(), colors_.end(), static_cast<int>(c)) == colors_.end()) {
          std::memcpy(after + to[c], before + from[c], from[c + 1] - from[c]);
        }
      }
      const int x = static_cast<int>(p % width), y = y0 - source.y + static_cast<int>(p / width);
      recodeColors(source, level, p, x, y, before, from, after, to);
    }
  }

  void recodeColors(const OIIO::ImageSpec& source, int level, std::size_t pixel, int x, int y,
                    const std::byte* before, const std::vector<std::size_t>& from, std::byte* after,
                    const std::vector<std::size_t>& to) {
    std::array<float, 3> change = {};
    bool clipped = false;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto channel = static_cast<std::size_t>(colors_[c]);
      const OIIO::TypeDesc type = written_.channelformat(colors_[c]);
      const float stored = sampleAt(before + from[channel], source.channelformat(colors_[c]));
      const float value = changed(level, c, pixel, x, y, stored);
      change[c] = value - stored;
      putSample(value, type, after + to[channel]);
      clipped = clipped ||
                (type == OIIO::TypeHalf && std::isfinite(value) && std::abs(value) >= kLargestHalf);
    }
    nextChange_.add(x, y, source.width, source.height, change);
    if (clipped && level == 0) ++*clipped_;
  }

  std::shared_ptr<ImageReader> reader_;
  int part_;
  std::array<int, 3> colors_;
  ImageFrame frame_;
  OIIO::ImageSpec written_;
  std::vector<OIIO::ImageSpec> levels_;
  std::shared_ptr<std::size_t> clipped_;
  std::vector<Plane> planes_;
  std::vector<std::byte> native_;
  std::array<std::vector<float>, 3> edited_;
  LevelChange change_, nextChange_;  // of the level that is written, and of the one after it
};

// What of parts, tiles and levels can be written.
struct Layout {
  std::vector<int> parts;
  bool tiles = true;
  bool levels = true;
};

Layout layoutOf(ImageReader& reader, const std::string& place, const JobContext& context) {
  Layout layout;
  int tiled = 0, withLevels = 0;
  bool twoDirections = false;
  for (int index = 0; index < reader.partCount(); ++index) {
    const OIIO::ImageSpec spec = reader.levelSpec(index, 0);
    if (spec.deep || spec.width <= 0 || spec.height <= 0) continue;
    layout.parts.push_back(index);
    tiled += spec.tile_width > 0 ? 1 : 0;
    withLevels += reader.levelCount(index) > 1 ? 1 : 0;
    twoDirections = twoDirections || spec.get_int_attribute("openexr:levelmode") > kMipmap;
  }
  const bool severalParts = layout.parts.size() > 1;
  if (static_cast<int>(layout.parts.size()) < reader.partCount()) {
    context.say(place + ": parts with deep pixels are left out");
  }
  if (withLevels > 0 && (severalParts || twoDirections)) {
    layout.levels = false;
    context.say(place + ": the smaller levels of the source are left out");
  }
  if (severalParts && tiled > 0 && tiled < static_cast<int>(layout.parts.size())) {
    layout.tiles = false;
    context.say(place + ": the parts are written without tiles");
  }
  return layout;
}

void copyLayout(const OIIO::ImageSpec& from, const Layout& layout, OIIO::ImageSpec& to) {
  for (const std::string_view name : kLayoutNames) {
    if (const OIIO::ParamValue* value = from.find_attribute(std::string(name))) {
      to.extra_attribs.add_or_replace(*value);
    }
  }
  to.x = from.x;
  to.y = from.y;
  to.width = from.width;
  to.height = from.height;
  to.full_x = from.full_x;
  to.full_y = from.full_y;
  to.full_width = from.full_width;
  to.full_height = from.full_height;
  to.tile_width = layout.tiles ? from.tile_width : 0;
  to.tile_height = layout.tiles ? from.tile_height : 0;
  to.tile_depth = 1;
  if (layout.tiles && layout.levels) return;
  to.attribute("openexr:levelmode", 0);
  to.erase_attribute("textureformat");
}

// Without the level that may follow: "dwaa" of "dwaa:45".
std::string compressionOf(const OIIO::ImageSpec& spec) {
  const std::string compression(spec.get_string_attribute("compression", "zip"));
  return compression.substr(0, compression.find(':'));
}

bool losesNothing(const OIIO::ImageSpec& spec) {
  constexpr std::array<std::string_view, 5> kLossless = {"none", "rle", "zips", "zip", "piz"};
  const std::string compression = compressionOf(spec);
  if (compression == "pxr24") {  // of a float it drops 8 bits
    for (int c = 0; c < spec.nchannels; ++c) {
      if (spec.channelformat(c) == OIIO::TypeFloat) return false;
    }
    return true;
  }
  return std::find(kLossless.begin(), kLossless.end(), compression) != kLossless.end();
}

// As the source, unless that would lose something of what is written.
void setCompression(const OIIO::ImageSpec& source, OIIO::ImageSpec& spec) {
  spec.attribute("compression", compressionOf(source));
  if (!losesNothing(spec)) spec.attribute("compression", "zip");
}

void sayChangedCompressions(ImageReader& reader, const std::vector<OutputPart>& parts,
                            const std::vector<int>& indices, const std::string& place,
                            const JobContext& context) {
  std::vector<std::string> changed;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string before = compressionOf(reader.levelSpec(indices[i], 0));
    const bool isSame = before == compressionOf(parts[i].spec);
    if (!isSame && std::find(changed.begin(), changed.end(), before) == changed.end())
      changed.push_back(before);
  }
  if (changed.empty()) return;
  context.say(place + ": the source is compressed with " + wordList(changed, " and ") +
              ", which would lose something at each writing; zip, which loses nothing, is "
              "written instead");
}

// The header of a part that is copied as it is.
OIIO::ImageSpec copiedSpec(const OIIO::ImageSpec& source, const Layout& layout) {
  OIIO::ImageSpec spec = source;
  for (const char* ofTheFile : {"oiio:subimages", "openexr:chunkCount", "openexr:lineOrder"})
    spec.erase_attribute(ofTheFile);
  copyLayout(source, layout, spec);
  setCompression(source, spec);
  return spec;
}

// All channels of the source, the colours in the type of the output.
OIIO::ImageSpec editedSpec(const OIIO::ImageSpec& spec, const OIIO::ImageSpec& source,
                           const std::array<int, 3>& colors, SampleType type,
                           const Layout& layout) {
  OIIO::ImageSpec edited = spec;
  edited.nchannels = source.nchannels;
  edited.channelnames = source.channelnames;
  edited.alpha_channel = source.alpha_channel;
  edited.z_channel = source.z_channel;
  edited.channelformats.clear();
  for (int c = 0; c < source.nchannels; ++c)
    edited.channelformats.push_back(source.channelformat(c));
  for (const int color : colors)
    edited.channelformats[static_cast<std::size_t>(color)] = oiioType(type);
  copyLayout(source, layout, edited);
  setCompression(source, edited);
  return edited;
}

std::vector<OIIO::ImageSpec> levelSpecs(ImageReader& reader, int part, const Layout& layout,
                                        const OIIO::ImageSpec& first) {
  std::vector<OIIO::ImageSpec> specs;
  if (!layout.levels || !layout.tiles) return specs;
  for (int level = 1; level < reader.levelCount(part); ++level) {
    const OIIO::ImageSpec size = reader.levelSpec(part, level);
    OIIO::ImageSpec spec = first;
    spec.x = size.x;
    spec.y = size.y;
    spec.width = size.width;
    spec.height = size.height;
    specs.push_back(spec);
  }
  return specs;
}

// OpenEXR wants these alike in all parts.
void shareColors(const OIIO::ImageSpec& edited, OIIO::ImageSpec& other) {
  for (const char* name : {"chromaticities", "whiteLuminance"}) {
    other.erase_attribute(name);
    if (const OIIO::ParamValue* value = edited.find_attribute(name)) {
      other.extra_attribs.add_or_replace(*value);
    }
  }
}

}  // namespace

Result<ExrEdition> makeExrEdition(const ImageContent& content, const OIIO::ImageSpec& spec,
                                  const OIIO::ImageSpec& plain, SampleType type,
                                  const std::string& place, const JobContext& context) {
  const ImageHeader& source = *content.source;
  CUTIS_TRY(opened, ImageReader::open(source.file, context));
  const auto reader = std::make_shared<ImageReader>(std::move(opened));
  const Layout layout = layoutOf(*reader, place, context);
  ExrEdition edition;
  for (const int index : layout.parts) {
    const OIIO::ImageSpec native = reader->levelSpec(index, 0);
    OutputPart part;
    if (index == source.layer.part) {
      part.spec = editedSpec(spec, native, *source.layer.colors, type, layout);
      edition.plain.push_back(editedSpec(plain, native, *source.layer.colors, type, layout));
      part.levels = levelSpecs(*reader, index, layout, part.spec);
      const auto rows =
          std::make_shared<EditedRows>(reader, content, part.spec, part.levels, edition.clipped);
      part.nativeRows = [rows](int level, int y0, int y1, std::vector<std::byte>& bytes) {
        return rows->fill(level, y0, y1, bytes);
      };
    } else {
      part.spec = copiedSpec(native, layout);
      shareColors(spec, part.spec);
      edition.plain.push_back(part.spec);
      part.levels = levelSpecs(*reader, index, layout, part.spec);
      part.nativeRows = [reader, index](int level, int y0, int y1, std::vector<std::byte>& bytes) {
        return reader->readNative(index, level, y0, y1, bytes);
      };
    }
    edition.parts.push_back(std::move(part));
  }
  sayChangedCompressions(*reader, edition.parts, layout.parts, place, context);
  return edition;
}

}  // namespace cutis
