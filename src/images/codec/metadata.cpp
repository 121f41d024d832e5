#include "src/images/codec/metadata.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "src/images/codec/metadata_access.h"

namespace cutis {

struct ImageMetadata::Attributes {
  OIIO::ParamValueList values;
};

namespace {

constexpr std::size_t kLongestName = 128;
constexpr int kLargestValueBytes = 1 << 16;
constexpr std::size_t kMostValues = 1024;

// What OpenImageIO and its formats say of the file itself, and our own attributes.
constexpr std::array<std::string_view, 15> kStoragePrefixes = {
    "oiio:",     "tiff:",          "png:",       "jpeg:",           "openexr:",
    "bmp:",      "targa:",         "hdr:",       "iccprofile",      "cutis:",
    "thumbnail", "exif:makernote", "exif:pixel", "exif:colorspace", "exif:interoperability"};

// Attributes with a fixed meaning or type in an EXR header, and others that name the storage.
constexpr std::array<std::string_view, 37> kStorageNames = {"acesimagecontainerflag",
                                                            "adoptedneutral",
                                                            "capdate",
                                                            "channels",
                                                            "chromaticities",
                                                            "chunkcount",
                                                            "colorinteropid",
                                                            "colorspace",
                                                            "compression",
                                                            "compressionquality",
                                                            "datawindow",
                                                            "displaywindow",
                                                            "dwacompressionlevel",
                                                            "envmap",
                                                            "fileformat",
                                                            "lineorder",
                                                            "maxsamplesperpixel",
                                                            "multiview",
                                                            "name",
                                                            "orientation",
                                                            "pixelaspectratio",
                                                            "planarconfig",
                                                            "preview",
                                                            "renderingtransform",
                                                            "lookmodtransform",
                                                            "screenwindowcenter",
                                                            "screenwindowwidth",
                                                            "textureformat",
                                                            "tiles",
                                                            "type",
                                                            "version",
                                                            "view",
                                                            "whiteluminance",
                                                            "wrapmodes",
                                                            "worldtocamera",
                                                            "worldtoscreen",
                                                            "dimensions"};

bool isStorage(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kStorageNames.begin(), kStorageNames.end(), lower) != kStorageNames.end() ||
         std::any_of(kStoragePrefixes.begin(), kStoragePrefixes.end(),
                     [&](std::string_view prefix) { return lower.starts_with(prefix); });
}

bool isPrintable(std::string_view name) {
  return !name.empty() && name.size() <= kLongestName &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return c >= 0x20 && c < 0x7f; });
}

std::size_t bytesOf(const OIIO::ParamValue& value) {
  if (value.type() == OIIO::TypeString) return value.get<OIIO::ustring>().size();
  return static_cast<std::size_t>(value.datasize());
}

}  // namespace

bool ImageMetadata::empty() const {
  return !attributes_ || attributes_->values.empty();
}

std::vector<std::string> ImageMetadata::names() const {
  std::vector<std::string> names;
  if (!attributes_) return names;
  for (const OIIO::ParamValue& value : attributes_->values)
    names.push_back(value.name().string());
  return names;
}

std::optional<std::string> ImageMetadata::text(const std::string& name) const {
  if (!attributes_) return std::nullopt;
  const auto found = attributes_->values.find(name);
  if (found == attributes_->values.end()) return std::nullopt;
  return found->get_string();
}

ImageMetadata MetadataAccess::from(const OIIO::ImageSpec& spec) {
  auto attributes = std::make_shared<ImageMetadata::Attributes>();
  for (const OIIO::ParamValue& value : spec.extra_attribs) {
    const std::string_view name = value.name().c_str();
    if (attributes->values.size() < kMostValues && isPrintable(name) && !isStorage(name) &&
        bytesOf(value) <= kLargestValueBytes) {
      attributes->values.push_back(value);
    }
  }
  ImageMetadata metadata;
  metadata.attributes_ = std::move(attributes);
  return metadata;
}

void MetadataAccess::add(const ImageMetadata& metadata, OIIO::ImageSpec& spec) {
  if (!metadata.attributes_) return;
  for (const OIIO::ParamValue& value : metadata.attributes_->values) {
    spec.extra_attribs.add_or_replace(value);
  }
}

}  // namespace cutis
