#include "src/images/codec/color_tags.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>

#include "core/spectra/rgb_primaries.h"

namespace cutis {
namespace {

constexpr char kOwnTag[] = "cutis:colorspace";
constexpr char kSrgb[] = "sRGB";
constexpr int kExifSrgb = 1;  // Exif 2.32, tag ColorSpace
constexpr int kExifUncalibrated = 0xffff;
constexpr double kPrimariesTolerance = 1e-3;
constexpr std::array<const RgbPrimaries*, 5> kKnownPrimaries = {&kRec709, &kAcesCg, &kAces2065,
                                                                &kRec2020, &kP3D65};

bool contains(std::string text, std::string_view part) {
  const auto lower = [](unsigned char c) { return static_cast<char>(std::tolower(c)); };
  std::transform(text.begin(), text.end(), text.begin(), lower);
  return text.find(part) != std::string::npos;
}

// Profiles of the common spaces go by many descriptions: "sRGB IEC61966-2.1", "sRGB built-in", …
std::string fromProfile(const std::string& description) {
  if (contains(description, "srgb") || description == "c2") return kSrgb;
  if (contains(description, "display p3")) return "Display P3";
  if (contains(description, "adobe rgb")) return "Adobe RGB (1998)";
  return description;
}

std::string fromChromaticities(const OIIO::ImageSpec& spec) {
  std::array<float, 8> file = {};
  const OIIO::TypeDesc eightFloats(OIIO::TypeDesc::FLOAT, 8);
  if (!spec.getattribute("chromaticities", eightFloats, file.data())) return {};
  for (const RgbPrimaries* primaries : kKnownPrimaries) {
    const auto close = [](float a, double b) { return std::abs(a - b) < kPrimariesTolerance; };
    if (std::equal(file.begin(), file.end(), primaries->chromaticities.begin(), close)) {
      return std::string(primaries->name);
    }
  }
  return "unknown primaries";
}

void setChromaticities(const std::string& name, OIIO::ImageSpec& spec) {
  for (const RgbPrimaries* primaries : kKnownPrimaries) {
    if (name != primaries->name) continue;
    std::array<float, 8> values = {};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = static_cast<float>(primaries->chromaticities[i]);
    }
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), values.data());
  }
}

}  // namespace

std::string colorSpaceOf(ImageFileKind kind, const OIIO::ImageSpec& spec) {
  if (const std::string own(spec.get_string_attribute(kOwnTag)); !own.empty()) return own;
  const std::string profile(spec.get_string_attribute("ICCProfile:profile_description"));
  if (!profile.empty()) return fromProfile(profile);
  const std::string tag(spec.get_string_attribute("oiio:ColorSpace"));
  switch (kind) {
    case ImageFileKind::openExr:
      return fromChromaticities(spec);
    case ImageFileKind::tiff:
      // Without the tag OpenImageIO still answers sRGB; and a float file with a camera's tag is
      // what is left of a photograph that has been made linear.
      return spec.get_int_attribute("Exif:ColorSpace") == kExifSrgb &&
                     !spec.format.is_floating_point()
                 ? kSrgb
                 : "";
    case ImageFileKind::radiance:
      return {};
    default:
      return tag;
  }
}

bool tagColorSpace(ImageFileKind kind, SampleType type, const std::string& name,
                   OIIO::ImageSpec& spec) {
  // With nothing at all in the EXIF block OpenImageIO fails to write it.
  if (kind == ImageFileKind::tiff && name != kSrgb) {
    spec.attribute("Exif:ColorSpace", kExifUncalibrated);
  }
  if (name.empty()) return true;
  const bool linear = name == kRec709.name;
  spec.attribute("oiio:ColorSpace", linear ? "Linear" : name);
  switch (kind) {
    case ImageFileKind::openExr:
      spec.attribute(kOwnTag, name);
      setChromaticities(name, spec);
      return true;
    case ImageFileKind::png:
      return true;
    case ImageFileKind::tiff:
      return isInteger(type) ? name == kSrgb : linear;
    default:
      return name == kSrgb;
  }
}

}  // namespace cutis
