#include "src/images/image_layers.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>
#include <utility>

#include "core/base/echoed_text.h"
#include "core/base/word_list.h"
#include "src/images/layer_choice.h"

namespace cutis {
namespace {

std::string lowered(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

std::string_view prefixOf(std::string_view channel) {
  const std::size_t point = channel.rfind('.');
  return point == std::string_view::npos ? std::string_view() : channel.substr(0, point + 1);
}

// Programs write "R", "r" and "red".
int channelCalled(const std::vector<std::string>& channels, const std::string& prefix,
                  std::string_view letter, std::string_view word) {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (prefixOf(channels[i]) != prefix) continue;
    const std::string base = lowered(std::string_view(channels[i]).substr(prefix.size()));
    if (base == letter || base == word) return static_cast<int>(i);
  }
  return -1;
}

ImageLayer layerOf(const ImagePart& part, const std::string& prefix) {
  const std::vector<std::string>& channels = part.spec.channelnames;
  ImageLayer layer;
  layer.part = part.index;
  layer.prefix = prefix;
  for (const std::string& channel : channels) {
    if (prefixOf(channel) == prefix) layer.channelNames.push_back(channel);
  }
  const std::array<int, 3> colors = {channelCalled(channels, prefix, "r", "red"),
                                     channelCalled(channels, prefix, "g", "green"),
                                     channelCalled(channels, prefix, "b", "blue")};
  if (*std::min_element(colors.begin(), colors.end()) >= 0) layer.colors = colors;
  layer.alpha = channelCalled(channels, prefix, "a", "alpha");
  return layer;
}

std::vector<std::string> prefixesOf(const ImagePart& part) {
  std::vector<std::string> prefixes;
  for (const std::string& channel : part.spec.channelnames) {
    const std::string prefix(prefixOf(channel));
    if (std::find(prefixes.begin(), prefixes.end(), prefix) == prefixes.end()) {
      prefixes.push_back(prefix);
    }
  }
  // Plain channels first, whatever the order of the file.
  std::stable_partition(prefixes.begin(), prefixes.end(),
                        [](const std::string& prefix) { return prefix.empty(); });
  return prefixes;
}

// A layer by itself: "albedo" of "albedo."; of plain channels nothing.
std::string ownName(const ImageLayer& layer) {
  return layer.prefix.empty() ? "" : layer.prefix.substr(0, layer.prefix.size() - 1);
}

std::string nameIn(const ImagePart& part, const ImageLayer& layer, bool severalParts) {
  const std::string own = ownName(layer);
  if (!severalParts) return own;
  const std::string partName = part.name.empty() ? std::to_string(part.index + 1) : part.name;
  return own.empty() || own == partName ? partName : partName + "." + own;
}

std::string shownName(const ImageLayer& layer) {
  if (!layer.name.empty()) return inQuotes(layer.name);
  return wordList(layer.channelNames, ", ");
}

LayerChoice usualLayer(const std::vector<ImageLayer>& layers) {
  std::vector<ImageLayer> plain, colored;
  for (const ImageLayer& layer : layers) {
    if (layer.colors) (layer.prefix.empty() ? plain : colored).push_back(layer);
  }
  std::vector<ImageLayer>& meant = plain.empty() ? colored : plain;
  if (meant.empty()) return {layers.front(), {}};
  LayerChoice choice = {std::move(meant.front()), {}};
  choice.others.assign(std::make_move_iterator(meant.begin() + 1),
                       std::make_move_iterator(meant.end()));
  return choice;
}

}  // namespace

Result<std::vector<ImageLayer>> layersOf(ImageReader& reader) {
  std::vector<ImageLayer> layers;
  const bool isExr = reader.kind() == ImageFileKind::openExr;
  for (int index = 0; index < reader.partCount(); ++index) {
    const auto read = reader.part(index);
    // A part that is not read, such as one of deep pixels, does not keep the others from it.
    if (!read && reader.partCount() > 1) continue;
    if (!read) return read.failure();
    const ImagePart& part = read.value();
    for (const std::string& prefix : isExr ? prefixesOf(part) : std::vector<std::string>{""}) {
      ImageLayer layer = layerOf(part, prefix);
      if (!isExr) layer.channelNames = part.spec.channelnames;
      layer.name = nameIn(part, layer, reader.partCount() > 1);
      layers.push_back(std::move(layer));
    }
  }
  if (layers.empty()) CUTIS_CHECK(reader.part(0));  // says why
  return layers;
}

Result<LayerChoice> chooseLayer(const std::vector<ImageLayer>& layers, const std::string& name,
                                const std::string& place) {
  if (name.empty()) return usualLayer(layers);
  const auto named = std::find_if(layers.begin(), layers.end(),
                                  [&](const ImageLayer& layer) { return layer.name == name; });
  if (named != layers.end()) return LayerChoice{*named, {}};
  // Without its part, where that is enough to tell it from the others.
  const auto isMeant = [&](const ImageLayer& layer) { return ownName(layer) == name; };
  const auto meant = std::find_if(layers.begin(), layers.end(), isMeant);
  if (meant != layers.end() && std::count_if(layers.begin(), layers.end(), isMeant) == 1) {
    return LayerChoice{*meant, {}};
  }
  return inputError(
      place, "there is no layer " + inQuotes(name) + " in this file; it has " + layerNames(layers));
}

Result<std::vector<ImageLayer>> listLayers(const std::filesystem::path& path,
                                           const JobContext& context) {
  CUTIS_TRY(reader, ImageReader::open(path, context));
  return layersOf(reader);
}

std::string layerNames(const std::vector<ImageLayer>& layers) {
  std::vector<std::string> names;
  for (const ImageLayer& layer : layers)
    names.push_back(shownName(layer));
  return wordList(names, " and ");
}

}  // namespace cutis
