#include "src/images/color/file_colors.h"

#include <array>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/spectra/rgb_primaries.h"
#include "src/color/icc_profile.h"
#include "src/images/color/code_points.h"
#include "src/images/color/exif_color.h"
#include "src/images/color/heif_color.h"
#include "src/images/color/png_color.h"
#include "src/images/color/tiff_color.h"
#include "src/images/inputs/radiance_header.h"
#include "src/images/inputs/webp_chunks.h"

namespace cutis {
namespace {

constexpr char kOwnAttribute[] = "cutis:colorspace";
constexpr int kExifSrgb = 1;
constexpr int kExifAdobe = 2;  // of some cameras, beyond the standard

class Collector {
 public:
  Collector(const std::filesystem::path& path, ImageFileKind kind, const ImagePart& part)
      : path_(path), kind_(kind), part_(part), spec_(part.spec) {}

  FileColors collect() {
    const bool integer = isInteger(part_.type);
    colors_.byDefault = {ColorSource::formatDefault,
                         std::string("the default for ") + (integer ? "integers" : "floats"),
                         builtInColorSpace(integer ? "sRGB" : "Linear Rec.709"),
                         {}};
    if (part_.otherColors) {
      addStorage(*part_.otherColors);
      return std::move(colors_);
    }
    switch (kind_) {
      case ImageFileKind::openExr:
        addOpenExr();
        break;
      case ImageFileKind::png:
        addPng();
        break;
      case ImageFileKind::webP:
        addWebP();
        break;
      case ImageFileKind::heic:
        addHeif();
        break;
      case ImageFileKind::radiance:
        addRadiance();
        break;
      default:
        addProfile(iccProfileBytes(spec_), spec_.find_attribute("ICCProfile") != nullptr);
        if (kind_ == ImageFileKind::tiff)
          add(tiffTagStatement(path_, colors_.byDefault.space.matrix->curves.front()));
    }
    // A float file with a camera's tag is what is left of a photograph that has been made linear.
    if (integer) addExif();
    return std::move(colors_);
  }

 private:
  void add(ColorSource source, std::string origin, ColorSpace space) {
    add({source, std::move(origin), std::move(space), {}});
  }
  // Statements that leave everything open are none.
  void add(ColorStatement statement) {
    if (statement.space.empty() && statement.objection.empty()) return;
    colors_.statements.push_back(std::move(statement));
  }

  void addStorage(const StoredColors& stored) {
    colors_.isConverted = bool(stored.toLinearRec709);
    ColorSpace space;
    if (colors_.isConverted) space = builtInColorSpace("Linear Rec.709");
    add({ColorSource::storage, "its storage as " + stored.name, std::move(space),
         stored.objection});
  }

  void addNamed(const std::string& name) {
    ColorStatement statement = {
        ColorSource::ownAttribute, "its attribute " + std::string(kOwnAttribute), {}, {}};
    auto space = namedColorSpace(name, path_.string());
    if (space)
      statement.space = std::move(space).value();
    else
      statement.objection = "says '" + name.substr(0, 80) + "', which is not known";
    add(std::move(statement));
  }

  void addPrimaries(ColorSource source, const std::string& origin,
                    const std::array<double, 8>& chromaticities, const TransferCurve& curve) {
    ColorStatement statement = {source, origin, {}, {}};
    auto space = spaceOfPrimaries(chromaticities, curve, path_.string());
    if (space)
      statement.space = std::move(space).value();
    else
      statement.objection = "says primaries that span no colours";
    add(std::move(statement));
  }

  void addOpenExr() {
    const std::string own(spec_.get_string_attribute(kOwnAttribute));
    if (!own.empty()) addNamed(own);
    std::array<float, 8> file = {};
    if (spec_.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8),
                           file.data())) {
      std::array<double, 8> chromaticities = {};
      std::copy(file.begin(), file.end(), chromaticities.begin());
      addPrimaries(ColorSource::chromaticities, "its attribute chromaticities", chromaticities, {});
    }
    add(statementOfInteropId(std::string(spec_.get_string_attribute("colorInteropID")),
                             "its attribute colorInteropID"));
    if (spec_.get_int_attribute("acesImageContainerFlag") == 1) {
      add(ColorSource::acesContainer, "its attribute acesImageContainerFlag",
          builtInColorSpace(std::string(kAces2065.name)));
    }
  }

  void addRadiance() {
    if (const auto primaries = readRadianceHeader(path_).primaries)
      addPrimaries(ColorSource::chromaticities, "its line PRIMARIES", *primaries, {});
  }

  void addPng() {
    const PngColors png = readPngColors(path_);
    if (png.cicp) add(statementOf(*png.cicp, bits(), "its cICP chunk"));
    if (png.profile) addProfile(*png.profile, true);
    if (png.hasSrgb) add(ColorSource::srgbChunk, "its sRGB chunk", builtInColorSpace("sRGB"));
    if (png.gamma && *png.gamma > 0.0) {
      addPrimaries(ColorSource::gammaChunk,
                   png.chromaticities ? "its gAMA chunk with cHRM" : "its gAMA chunk",
                   png.chromaticities.value_or(kRec709.chromaticities),
                   TransferCurve::power(1.0 / *png.gamma));
    } else if (png.chromaticities) {
      addPrimaries(ColorSource::gammaChunk, "its cHRM chunk", *png.chromaticities,
                   TransferCurve::srgb());
    }
    exif_ = png.exif;
  }

  void addWebP() {
    const WebPChunks webP = readWebPChunks(path_);
    if (webP.profile) addProfile(*webP.profile, true);
    exif_ = webP.exif;
  }

  void addHeif() {
    const HeifColors heif = readHeifColors(path_);
    if (heif.profile) addProfile(*heif.profile, true);
    if (heif.codePoints) add(statementOf(*heif.codePoints, bits(), "its code points (nclx)"));
  }

  int bits() const { return part_.type == SampleType::uint8 ? 8 : 16; }

  void addProfile(std::string_view bytes, bool isThere) {
    if (!isThere) return;
    ColorStatement statement = {ColorSource::iccProfile, "its ICC profile", {}, {}};
    auto profile = readIccProfile(bytes, path_.string());
    if (!profile) {
      statement.objection = "cannot be used (" + profile.error().message + ")";
    } else if (profile.value().space.empty()) {
      statement.objection = "is for neither RGB nor grey pixels";
    } else if (profile.value().kind == ProfileKind::grey && part_.channelIndex("R") >= 0) {
      statement.objection = "is for grey pixels, but the picture is in colour";
    } else {
      if (!profile.value().description.empty())
        statement.origin += " '" + profile.value().description + "'";
      statement.space = std::move(profile.value().space);
    }
    add(std::move(statement));
  }

  void addExif() {
    ExifColors exif;
    if (kind_ == ImageFileKind::tiff) {
      std::ifstream file(path_, std::ios::binary);
      exif = exifColorsOf(file);
    } else {
      std::istringstream block(kind_ == ImageFileKind::jpeg ? exifBlockOfJpeg(path_) : exif_);
      exif = exifColorsOf(block);
    }
    if (exif.colorSpace == kExifSrgb) {
      add(ColorSource::exif, "its EXIF tag ColorSpace", builtInColorSpace("sRGB"));
    } else if (exif.colorSpace == kExifAdobe) {
      add(ColorSource::exif, "its EXIF tag ColorSpace", builtInColorSpace("Adobe RGB (1998)"));
    }
    if (exif.interopIndex == "R03") {
      add(ColorSource::exif, "its EXIF tag InteroperabilityIndex",
          builtInColorSpace("Adobe RGB (1998)"));
    } else if (exif.interopIndex == "R98" && !exif.colorSpace) {
      add(ColorSource::exif, "its EXIF tag InteroperabilityIndex", builtInColorSpace("sRGB"));
    }
  }

  const std::filesystem::path& path_;
  ImageFileKind kind_;
  const ImagePart& part_;
  const OIIO::ImageSpec& spec_;
  std::string exif_;  // of a PNG or WebP file
  FileColors colors_;
};

}  // namespace

FileColors fileColors(const std::filesystem::path& path, ImageFileKind kind,
                      const ImagePart& part) {
  return Collector(path, kind, part).collect();
}

}  // namespace cutis
