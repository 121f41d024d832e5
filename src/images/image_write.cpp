#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

#include "src/files/io/atomic_write.h"
#include "src/images/codec/image_formats.h"
#include "src/images/codec/image_writer.h"
#include "src/images/codec/metadata_access.h"
#include "src/images/codec/oiio_text.h"
#include "src/images/color/output_colors.h"
#include "src/images/image_file.h"

namespace cutis {
namespace {

std::string listOf(const std::vector<SampleType>& types) {
  std::string list;
  for (const SampleType type : types)
    list += (list.empty() ? "" : ", ") + sampleTypeName(type);
  return list;
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
  spec.attribute("oiio:UnassociatedAlpha", 1);  // colours are not to be divided by alpha
  if (!format.compression.empty()) spec.attribute("compression", std::string(format.compression));
  if (format.quality > 0) spec.attribute("CompressionQuality", format.quality);
  if (format.kind == ImageFileKind::jpeg) spec.attribute("jpeg:subsampling", "4:4:4");
  return spec;
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

bool canStateColors(const std::filesystem::path& path, const ColorSpace& space) {
  return canStateColors(writtenFormat(path).value()->kind, space);
}

Status writeImage(const std::filesystem::path& path, const ImageContent& content, SampleType type,
                  const JobContext& context) {
  assert(!content.channels.empty() && content.channels.size() == content.channelNames.size());
  CUTIS_CHECK(checkImageOutput(path, type));
  const ImageFormat& format = *writtenFormat(path).value();
  const std::string place = path.string(), formatName(format.name);
  const std::vector<std::size_t> channels = chosenChannels(content.channelNames, format);
  if (channels.size() < content.channels.size()) {
    context.say(place + ": " + formatName + " has room for " + std::to_string(channels.size()) +
                " of the " + std::to_string(content.channels.size()) +
                " channels; the others are left out");
  }
  OIIO::ImageSpec plain = plainSpec(content, channels, format, type);
  OutputPart part{plain, {}};
  for (const std::size_t i : channels)
    part.channels.push_back(content.channels[i]);
  MetadataAccess::add(content.metadata, part.spec);
  StatedColors stated;
  for (OIIO::ImageSpec* spec : {&plain, &part.spec})
    stated = stateColors(format.kind, content.colorSpace, *spec);
  if (!stated.complete) {
    context.say(place + ": " + formatName + " cannot say here that its colours are " +
                content.colorSpace.name + "; name it when you use the file");
  }
  return writeAtomically(path, [&](const std::filesystem::path& temporary) {
    return writeParts(temporary, place, format.kind, type, {part}, {plain}, stated.pngChunks,
                      context);
  });
}

}  // namespace cutis
