#include <cassert>

#include <nlohmann/json.hpp>

#include "core/skin/profile/parameter.h"
#include "src/files/io/atomic_write.h"
#include "src/images/codec/image_writer.h"
#include "src/images/codec/metadata_access.h"
#include "src/images/maps/maps_file.h"
#include "src/images/maps/maps_format.h"

namespace cutis {
namespace {

using namespace maps_format;

std::string sourcesText(const std::vector<SourceReference>& sources) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SourceReference& source : sources) {
    list.push_back({{"file", source.file}, {"hash", source.hash}});
  }
  // A file's name may be no UTF-8.
  return list.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

OIIO::ImageSpec specOf(const std::string& part, const std::vector<std::string>& channels,
                       const Plane& size) {
  OIIO::ImageSpec spec(size.width(), size.height(), static_cast<int>(channels.size()),
                       OIIO::TypeFloat);
  spec.channelnames = channels;
  spec.alpha_channel = -1;
  spec.attribute("oiio:subimagename", part);
  spec.attribute("compression", "zip");
  return spec;
}

void addAttributes(const MapsAttributes& attributes, OIIO::ImageSpec& spec) {
  spec.attribute(kVersion, kNewestVersion);
  spec.attribute(kProfile, attributes.profileName);
  spec.attribute(kProfileJson, attributes.profileJson);
  spec.attribute(kRig, attributes.rigName);
  spec.attribute(kMethod, attributes.method);
  spec.attribute(kExposure, OIIO::TypeDesc::DOUBLE, &attributes.exposure);
  if (attributes.specularShare > 0.0)
    spec.attribute(kSpecularShare, OIIO::TypeDesc::DOUBLE, &attributes.specularShare);
  if (!attributes.fit.empty()) spec.attribute(kFit, attributes.fit);
  spec.attribute(kSources, sourcesText(attributes.sources));
  spec.attribute(kSourceColorSpace, attributes.sourceColorSpace);
}

std::vector<std::string> coefficientNames(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < count; ++c)
    names.push_back(coefficientName(c));
  return names;
}

std::vector<std::string> writtenNames() {
  std::vector<std::string> names;
  for (const Parameter parameter : kParameters)
    names.emplace_back(parameterName(parameter));
  return names;
}

std::vector<Plane> constantPlanes(const ChromophoreMaps& maps) {
  std::vector<Plane> planes;
  for (const Plane& plane : maps.constants) {
    if (!plane.empty()) planes.push_back(plane);
  }
  return planes;
}

std::vector<OutputPart> partsOf(const MapsFile& file) {
  const Plane& size = file.maps.state;
  std::vector<OutputPart> parts;
  const auto add = [&](const char* name, const std::vector<std::string>& channels,
                       std::vector<Plane> planes) {
    parts.push_back({specOf(name, channels, size), std::move(planes)});
  };
  add(kChromophoresPart, writtenNames(), {file.maps.values.begin(), file.maps.values.end()});
  add(kStatePart, {"state"}, {file.maps.state});
  if (!file.deviations.empty()) add(kDeviationPart, writtenNames(), file.deviations);
  if (!file.residuals.empty()) add(kResidualPart, file.residualNames, file.residuals);
  if (!file.shading.empty()) add(kShadingPart, {"shading"}, {file.shading});
  const std::vector<std::string> constants = constantNames(file.maps.free());
  if (!constants.empty()) add(kConstantsPart, constants, constantPlanes(file.maps));
  if (!file.constantDeviations.empty()) {
    add(kConstantsDeviationPart, constants, file.constantDeviations);
  }
  if (!file.maps.coefficients.empty()) {
    add(kDiscrepancyPart, coefficientNames(file.maps.coefficients.size()), file.maps.coefficients);
    parts.back().spec.set_format(OIIO::TypeHalf);
    // Zip makes noise of halves a sixth smaller still, in six times as long.
    parts.back().spec.attribute("compression", "rle");
    parts.front().spec.attribute(kSurface, surfaceLightName(file.maps.surface));
  }
  addAttributes(file.attributes, parts.front().spec);
  return parts;
}

}  // namespace

Status checkMapsName(const std::filesystem::path& path) {
  const auto format = writtenFormat(path);
  if (format && format.value()->holdsMaps) return {};
  return usageError(path.string(), "maps are written as OpenEXR; name the file with .exr");
}

Status writeMaps(const std::filesystem::path& path, const MapsFile& file,
                 const JobContext& context) {
  assert(file.maps.width() > 0 && file.residuals.size() == file.residualNames.size());
  CUTIS_CHECK(checkMapsName(path));
  std::vector<OutputPart> parts = partsOf(file);
  std::vector<OIIO::ImageSpec> plain;
  for (OutputPart& part : parts) {
    plain.push_back(part.spec);
    // In all parts alike: EXR demands that some attributes do not differ between them.
    MetadataAccess::add(file.metadata, part.spec);
  }
  return writeAtomically(path, [&](const std::filesystem::path& temporary) -> Status {
    // Floats lose nothing.
    CUTIS_CHECK(writeParts(temporary, path.string(), ImageFileKind::openExr, SampleType::float32,
                           parts, plain, {}, context));
    return {};
  });
}

}  // namespace cutis
