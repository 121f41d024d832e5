#include "src/app/open/image_inspection.h"

#include <algorithm>

#include "core/base/word_list.h"
#include "src/color/color_space.h"
#include "src/images/capture/capture_file.h"
#include "src/images/codec/image_formats.h"
#include "src/images/image_file.h"
#include "src/images/image_layers.h"
#include "src/images/maps/maps_file.h"

namespace cutis {
namespace {

std::string describeFormat(const ImageHeader& header) {
  std::string text = std::string(imageFormat(header.kind).name) + ", " +
                     std::to_string(header.width) + " × " + std::to_string(header.height) +
                     " pixels, " + sampleTypeName(header.sourceType);
  if (header.layer.alpha >= 0) {
    text += header.alphaKind == AlphaKind::associated ? ", colours multiplied by alpha"
                                                      : ", with straight alpha";
  }
  return text;
}

LayerInspection inspectLayer(const ImageLayer& layer, const ImageHeader& header,
                             const std::string& place) {
  LayerInspection inspection;
  inspection.name = layer.name;
  inspection.channels = wordList(layer.channelNames, " and ");
  inspection.hasColors = layer.colors.has_value();
  const auto decided = decideColors(header.colors, {}, place);
  inspection.isDecided = static_cast<bool>(decided);
  if (decided) {
    inspection.decision = decided.value().sentence;
    inspection.contradictions = decided.value().contradictions;
  } else if (decided.failed()) {
    inspection.decision = decided.error().message;
  }
  for (const ColorStatement& statement : header.colors.statements) {
    inspection.statements.push_back(statement.origin + ": " + statement.meaning());
  }
  return inspection;
}

}  // namespace

bool ImageInspection::opensByItself() const {
  return isLayerDecided && layers[usualLayer].hasColors && layers[usualLayer].isDecided;
}

Result<ImageInspection> inspectImage(const std::filesystem::path& path, const JobContext& context) {
  if (looksLikeCapture(path)) {
    return inputError(path.string(),
                      "a capture says in its capture.json how it is read; open it as it is");
  }
  if (isMapsFile(path)) {
    return inputError(path.string(),
                      "maps say themselves how they are read; open them as they are");
  }
  CUTIS_TRY(usual, readImageHeader(path, context));
  CUTIS_TRY(layers, listLayers(path, context));
  ImageInspection inspection;
  inspection.format = describeFormat(usual);
  inspection.isLayerDecided = !usual.isLayerOpen();
  inspection.colorSpaces = colorSpaceNames();
  for (const ImageLayer& layer : layers) {
    if (layer.name == usual.layer.name) inspection.usualLayer = inspection.layers.size();
    CUTIS_TRY(header, readImageHeader(path, context, layer.name));
    inspection.layers.push_back(inspectLayer(layer, header, path.string()));
  }
  return inspection;
}

}  // namespace cutis
