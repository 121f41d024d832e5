#include <algorithm>
#include <cmath>

#include "core/base/echoed_text.h"
#include "core/skin/profile/parameter.h"
#include "src/files/io/json_file.h"
#include "src/images/codec/image_reader.h"
#include "src/images/codec/metadata_access.h"
#include "src/images/maps/maps_file.h"
#include "src/images/maps/maps_format.h"
#include "src/images/maps/maps_repair.h"

namespace cutis {
namespace {

using namespace maps_format;

constexpr char kWayOut[] = "fit an image first";

std::string textAttribute(const OIIO::ImageSpec& spec, const char* name) {
  return std::string(spec.get_string_attribute(name));
}

// The parts of an open file, by name.
class Parts {
 public:
  static Result<Parts> of(ImageReader& reader) {
    Parts parts;
    for (int i = 0; i < reader.partCount(); ++i) {
      CUTIS_TRY(part, reader.part(i));
      parts.parts_.push_back(std::move(part));
    }
    return parts;
  }

  const ImagePart* find(std::string_view name) const {
    const auto found = std::find_if(parts_.begin(), parts_.end(),
                                    [&](const ImagePart& part) { return part.name == name; });
    return found == parts_.end() ? nullptr : &*found;
  }

 private:
  std::vector<ImagePart> parts_;
};

Status checkIsMaps(const ImagePart* chromophores, const std::string& place) {
  if (chromophores == nullptr || chromophores->spec.get_int_attribute(kVersion, 0) < 1) {
    return inputError(place, std::string("this is not a Cutis maps file; ") + kWayOut);
  }
  const int version = chromophores->spec.get_int_attribute(kVersion, 0);
  if (version > kNewestVersion) {
    return inputError(place, "the maps are of version " + std::to_string(version) +
                                 ", written by a newer version of Cutis; this one reads up to " +
                                 std::to_string(kNewestVersion));
  }
  return {};
}

Status checkSize(const ImagePart& part, const ImagePart& first, const std::string& place) {
  if (part.width() == first.width() && part.height() == first.height()) return {};
  return inputError(place, "part " + inQuotes(part.name) + " is " + std::to_string(part.width()) +
                               " × " + std::to_string(part.height()) + " pixels but part " +
                               inQuotes(first.name) + " is " + std::to_string(first.width()) +
                               " × " + std::to_string(first.height()) + "; fit the image again");
}

// What is stored of a part, in pixels of the picture.
Rect storedIn(const ImagePart& part) {
  const int x0 = part.window.x0, y0 = part.window.y0;
  const Rect& stored = part.stored;
  return {stored.x0 - x0, stored.y0 - y0, stored.x1 - x0, stored.y1 - y0};
}

Result<std::vector<int>> channelsNamed(const ImagePart& part, const std::vector<std::string>& names,
                                       const std::string& place) {
  std::vector<int> channels;
  for (const std::string& name : names) {
    channels.push_back(part.channelIndex(name));
    if (channels.back() < 0) {
      return inputError(place, "part " + inQuotes(part.name) + " has no channel " + inQuotes(name) +
                                   "; fit the image again");
    }
  }
  return channels;
}

std::vector<std::string> parameterNames() {
  std::vector<std::string> names;
  for (const Parameter parameter : kParameters)
    names.emplace_back(parameterName(parameter));
  return names;
}

Result<std::vector<SourceReference>> parseSources(const std::string& text,
                                                  const std::string& place) {
  std::vector<SourceReference> sources;
  if (text.empty()) return sources;
  // The list alone is no document.
  CUTIS_TRY(root, parseJson("{\"sources\": " + text + "}", place + ": attribute cutis:sources"));
  CUTIS_TRY(list, root.array("sources"));
  for (const JsonValue& entry : list) {
    if (!entry.isObject()) return entry.error("an object with a file and a hash");
    CUTIS_TRY(file, entry.text("file"));
    CUTIS_TRY(hash, entry.text("hash"));
    sources.push_back({file, hash});
  }
  return sources;
}

double numberAttribute(const OIIO::ImageSpec& spec, const char* name, double otherwise) {
  double value = otherwise;
  if (spec.getattribute(name, OIIO::TypeDesc::DOUBLE, &value)) return value;
  return double{spec.get_float_attribute(name, static_cast<float>(otherwise))};
}

Result<MapsAttributes> attributesOf(const OIIO::ImageSpec& spec, const std::string& place) {
  MapsAttributes attributes;
  attributes.profileName = textAttribute(spec, kProfile);
  attributes.profileJson = textAttribute(spec, kProfileJson);
  attributes.rigName = textAttribute(spec, kRig);
  attributes.method = textAttribute(spec, kMethod);
  attributes.sourceColorSpace = textAttribute(spec, kSourceColorSpace);
  attributes.fit = textAttribute(spec, kFit);
  const double exposure = numberAttribute(spec, kExposure, 1.0);
  attributes.exposure = std::isfinite(exposure) && exposure > 0.0 ? exposure : 1.0;
  const double share = numberAttribute(spec, kSpecularShare, 0.0);
  attributes.specularShare = share > 0.0 && share < 1.0 ? share : 0.0;
  CUTIS_TRY(sources, parseSources(textAttribute(spec, kSources), place));
  attributes.sources = std::move(sources);
  return attributes;
}

class MapsReader {
 public:
  MapsReader(ImageReader& reader, Parts parts, PixelFormat format, std::shared_ptr<TileStore> store,
             const JobContext& context)
      : reader_(reader),
        parts_(std::move(parts)),
        format_(format),
        store_(std::move(store)),
        context_(context) {}

  Result<MapsFile> read() {
    const ImagePart* chromophores = parts_.find(kChromophoresPart);
    CUTIS_CHECK(checkIsMaps(chromophores, reader_.place()));
    first_ = chromophores;
    MapsFile file;
    CUTIS_TRY(attributes, attributesOf(chromophores->spec, reader_.place()));
    file.attributes = std::move(attributes);
    file.metadata = MetadataAccess::from(chromophores->spec);
    CUTIS_CHECK(readMapsThemselves(file.maps));
    if (const ImagePart* part = parts_.find(kDeviationPart)) {
      CUTIS_TRY(planes, readExtra(*part, parameterNames(), context_.child(0.6, 0.75)));
      file.deviations = std::move(planes);
    }
    if (const ImagePart* part = parts_.find(kResidualPart)) {
      CUTIS_TRY(planes, readExtra(*part, part->spec.channelnames, context_.child(0.75, 0.95)));
      file.residuals = std::move(planes);
      file.residualNames = part->spec.channelnames;
    }
    if (const ImagePart* part = parts_.find(kShadingPart)) {
      CUTIS_TRY(planes, readExtra(*part, {"shading"}, context_.child(0.95, 1.0)));
      file.shading = planes.front();
    }
    const ImagePart* part = parts_.find(kConstantsDeviationPart);
    const std::vector<std::string> names = constantNames(file.maps.free());
    if (part != nullptr && !names.empty()) {
      CUTIS_TRY(planes, readExtra(*part, names, context_.child(0.95, 1.0)));
      file.constantDeviations = std::move(planes);
    }
    return file;
  }

 private:
  Result<std::vector<Plane>> readNamed(const ImagePart& part, const std::vector<std::string>& names,
                                       PixelFormat format, const JobContext& context) {
    CUTIS_CHECK(checkSize(part, *first_, reader_.place()));
    CUTIS_TRY(channels, channelsNamed(part, names, reader_.place()));
    return reader_.read(part, channels, format, store_, context);
  }

  Result<std::vector<Plane>> readExtra(const ImagePart& part, const std::vector<std::string>& names,
                                       const JobContext& context) {
    CUTIS_TRY(planes, readNamed(part, names, format_, context));
    for (Plane& plane : planes)
      CUTIS_CHECK(zeroWhereNotFinite(plane, context));
    return planes;
  }

  Status readMapsThemselves(ChromophoreMaps& maps) {
    const ImagePart* state = parts_.find(kStatePart);
    if (state == nullptr) {
      return inputError(reader_.place(), "the part 'state' is missing; fit the image again");
    }
    CUTIS_TRY(values, readNamed(*first_, parameterNames(), format_, context_.child(0.0, 0.5)));
    std::copy(values.begin(), values.end(), maps.values.begin());
    // Small whole numbers: a half holds them.
    CUTIS_TRY(states, readNamed(*state, {"state"}, PixelFormat::half, context_.child(0.5, 0.6)));
    maps.state = states.front();
    Rect stored = intersection(storedIn(*first_), storedIn(*state));
    if (const ImagePart* part = parts_.find(kConstantsPart)) {
      CUTIS_CHECK(readConstants(*part, maps));
      stored = intersection(stored, storedIn(*part));
    }
    if (const ImagePart* part = parts_.find(kDiscrepancyPart)) {
      CUTIS_CHECK(readCoefficients(*part, maps));
      stored = intersection(stored, storedIn(*part));
    }
    CUTIS_CHECK(maskOutside(stored, maps, context_));
    CUTIS_TRY(spoiled, invalidateSpoiledPixels(maps, context_));
    if (spoiled > 0) {
      context_.say(reader_.place() + ": " + std::to_string(spoiled) +
                   " pixels have values that skin cannot have and were marked as invalid");
    }
    return {};
  }

  Status readConstants(const ImagePart& part, ChromophoreMaps& maps) {
    FreeConstants free;
    free.oxygenation = part.channelIndex(std::string(constantName(kOxygenation))) >= 0;
    free.thickness = part.channelIndex(std::string(constantName(kThickness))) >= 0;
    if (free.count() == 0) {
      return inputError(reader_.place(),
                        "part 'constants' has neither a channel 'oxygenation' nor "
                        "'thickness_mm'; fit the image again");
    }
    CUTIS_TRY(planes, readNamed(part, constantNames(free), format_, context_.child(0.6, 0.6)));
    auto next = planes.begin();
    for (const SkinConstant constant : kSkinConstants) {
      if (free.has(constant)) maps.constants[constant] = *next++;
    }
    return {};
  }

  Status readCoefficients(const ImagePart& part, ChromophoreMaps& maps) {
    std::vector<std::string> names;
    while (part.channelIndex(coefficientName(names.size())) >= 0)
      names.push_back(coefficientName(names.size()));
    const auto surface = surfaceLightByName(textAttribute(first_->spec, kSurface));
    if (names.empty() || names.size() > kMaximumCoefficients || !surface) {
      return inputError(reader_.place(),
                        "part 'discrepancy' must have channels 'd.0' to 'd." +
                            std::to_string(kMaximumCoefficients - 1) +
                            "' at most, and the attribute cutis:surface must say of which "
                            "discrepancy they are; fit the image again");
    }
    CUTIS_TRY(planes, readNamed(part, names, PixelFormat::half, context_.child(0.6, 0.6)));
    maps.coefficients = std::move(planes);
    maps.surface = *surface;
    return {};
  }

  ImageReader& reader_;
  Parts parts_;
  PixelFormat format_;
  std::shared_ptr<TileStore> store_;
  const JobContext& context_;
  const ImagePart* first_ = nullptr;
};

}  // namespace

bool isMapsFile(const std::filesystem::path& path) {
  const auto kind = identifyImageFile(path);
  if (!kind || kind.value() != ImageFileKind::openExr) return false;
  auto reader = ImageReader::open(path, {});
  if (!reader) return false;
  const auto parts = Parts::of(reader.value());
  if (!parts) return false;
  const ImagePart* part = parts.value().find(kChromophoresPart);
  return part != nullptr && part->spec.get_int_attribute(kVersion, 0) > 0;
}

Result<MapsFile> readMaps(const std::filesystem::path& path, PixelFormat format,
                          const std::shared_ptr<TileStore>& store, const JobContext& context) {
  CUTIS_TRY(reader, ImageReader::open(path, context));
  if (reader.kind() != ImageFileKind::openExr) {
    return inputError(reader.place(), std::string("this is not a Cutis maps file but a ") +
                                          std::string(imageFormat(reader.kind()).name) +
                                          " image; " + kWayOut);
  }
  CUTIS_TRY(parts, Parts::of(reader));
  return MapsReader(reader, std::move(parts), format, store, context).read();
}

}  // namespace cutis
