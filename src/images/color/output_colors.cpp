#include "src/images/color/output_colors.h"

#include <algorithm>
#include <array>
#include <optional>

#include "src/color/icc_profile.h"
#include "src/images/codec/oiio_text.h"
#include "src/images/color/code_points.h"
#include "src/images/color/jpeg_color.h"
#include "src/images/color/png_color.h"

namespace cutis {
namespace {

constexpr char kSrgb[] = "sRGB";
constexpr int kTagSrgb = 1;  // Exif 2.32, tag ColorSpace
constexpr int kTagUncalibrated = 0xffff;

// Statements that a picture may have carried along from its source.
constexpr std::array<const char*, 8> kStatements = {
    "oiio:ColorSpace", "oiio:Gamma",      "ICCProfile",       "chromaticities",
    "colorInteropID",  "Exif:ColorSpace", "cutis:colorspace", "acesImageContainerFlag"};

// The file's own profile, else one made for the space; empty if there is none.
std::string profileOf(const ColorSpace& space) {
  if (space.profile) return *space.profile;
  // Numbers as they are have no colours to speak of.
  return space.name == "Raw" ? std::string() : iccProfileOf(space);
}

bool stateInOpenExr(const ColorSpace& space, OIIO::ImageSpec& spec) {
  if (space.isNamed) spec.attribute("cutis:colorspace", space.name);
  const bool byPrimaries = space.isLinear() && space.matrix->chromaticities;
  if (byPrimaries) {
    std::array<float, 8> values = {};
    std::transform(space.matrix->chromaticities->begin(), space.matrix->chromaticities->end(),
                   values.begin(), [](double v) { return static_cast<float>(v); });
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), values.data());
  }
  return space.isNamed || byPrimaries;
}

std::string pngChunksOf(const ColorSpace& space, const OIIO::ImageSpec& spec,
                        const std::string& profile) {
  std::string chunks;
  const bool hasColors = spec.nchannels >= 3;
  // A profile of the source stands alone: it says more than four code points.
  const auto points = space.profile || !hasColors
                          ? std::nullopt
                          : codePointsOf(space, 8 * static_cast<int>(spec.format.size()));
  if (points) chunks += cicpChunk(*points);
  if (!profile.empty()) chunks += profileChunk(profile);
  return chunks;
}

}  // namespace

bool canStateColors(ImageFileKind kind, SampleType type, const ColorSpace& space) {
  OIIO::ImageSpec spec(1, 1, 3, oiioType(type));
  return stateColors(kind, space, spec).complete;
}

StatedColors stateColors(ImageFileKind kind, const ColorSpace& space, OIIO::ImageSpec& spec) {
  for (const char* name : kStatements)
    spec.erase_attribute(name);
  const bool isSrgb = space.name == kSrgb;
  // With nothing at all in the EXIF block OpenImageIO fails to write it.
  if (kind == ImageFileKind::tiff || (kind == ImageFileKind::jpeg && !space.empty()))
    spec.attribute("Exif:ColorSpace", isSrgb ? kTagSrgb : kTagUncalibrated);
  if (space.empty()) return {};
  if (kind == ImageFileKind::openExr) return {stateInOpenExr(space, spec)};
  const bool hasColors = spec.nchannels >= 3;
  const std::string profile = hasColors ? profileOf(space) : std::string();
  if (kind == ImageFileKind::png) {
    const bool chunkSays = isSrgb && !space.profile;
    if (chunkSays) spec.attribute("oiio:ColorSpace", kSrgb);
    const std::string chunks = chunkSays ? std::string() : pngChunksOf(space, spec, profile);
    return {chunkSays || !chunks.empty() || isSrgb, chunks};
  }
  if (kind == ImageFileKind::jpeg) {
    const std::string segments = profileSegments(profile);
    return {isSrgb || !segments.empty(), segments};
  }
  if (!profile.empty()) {
    spec.attribute("ICCProfile",
                   OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                   profile.data());
  }
  return {isSrgb || !profile.empty()};
}

}  // namespace cutis
