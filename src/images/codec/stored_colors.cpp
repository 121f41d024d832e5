#include "src/images/codec/stored_colors.h"

#include <array>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "core/spectra/colorimetry.h"
#include "core/spectra/rgb_primaries.h"
#include "src/color/icc_profile.h"
#include "src/images/inputs/ink_jpeg_input.h"

namespace cutis {
namespace {

// TIFF 6.0, tag PhotometricInterpretation, and its supplements.
constexpr int kSeparated = 5;
constexpr int kCieLab = 8;
constexpr int kIccLab = 9;
constexpr int kItuLab = 10;

// CIE 15:2018, §8.2.1.2, inverted.
double lightOf(double f) {
  constexpr double kKnee = 6.0 / 29.0;
  return f > kKnee ? f * f * f : 3.0 * kKnee * kKnee * (f - 4.0 / 29.0);
}

// A sample in the scale of L*, a* and b*.
struct LabScale {
  double lightness = 100.0;
  double steps = 0.0;  // of an integer's range; 0: floats are L*, a*, b* themselves
  double perUnit = 1.0;
  double zero = 0.0;  // of a* and b*, in steps; negative numbers are stored as complements if 0

  double chroma(float sample) const {
    if (steps == 0.0) return sample;
    double step = std::round(sample * steps);
    if (zero == 0.0 && step > steps / 2.0) step -= steps + 1.0;
    return (step - zero) / perUnit;
  }
};

LabScale scaleOf(int photometric, const OIIO::ImageSpec& spec) {
  const bool icc = photometric == kIccLab;
  switch (spec.format.basetype) {
    case OIIO::TypeDesc::UINT8:
      return {100.0, 255.0, 1.0, icc ? 128.0 : 0.0};
    case OIIO::TypeDesc::UINT16:
      return {icc ? 100.0 * 65535.0 / 65280.0 : 100.0, 65535.0, 256.0, icc ? 32768.0 : 0.0};
    default:
      return {1.0};
  }
}

StoredColors labColors(int photometric, const OIIO::ImageSpec& spec) {
  StoredColors colors;
  colors.name = "CIELab";
  const LabScale scale = scaleOf(photometric, spec);
  const Eigen::Vector3d d50(0.9642, 1.0, 0.8249);
  const Eigen::Matrix3d toRec709 =
      xyzFromRgb(kRec709).inverse() *
      adaptationMatrix(ChromaticAdaptation::bradford, d50, kRec709.xyzOfWhite());
  colors.toLinearRec709 = [=](std::span<const float> stored, std::span<float> rgb) {
    for (std::size_t i = 0; i + 2 < stored.size(); i += 3) {
      const double y = (scale.lightness * stored[i] + 16.0) / 116.0;
      const double x = y + scale.chroma(stored[i + 1]) / 500.0;
      const double z = y - scale.chroma(stored[i + 2]) / 200.0;
      const Eigen::Vector3d light =
          toRec709 * Eigen::Vector3d(d50[0] * lightOf(x), lightOf(y), d50[2] * lightOf(z));
      for (std::size_t c = 0; c < 3; ++c)
        rgb[i + c] = static_cast<float>(light[static_cast<Eigen::Index>(c)]);
    }
  };
  return colors;
}

StoredColors inkColors(const OIIO::ImageSpec& spec, const std::string& place) {
  StoredColors colors;
  colors.name = "CMYK";
  colors.channels = 4;
  const std::string_view bytes = iccProfileBytes(spec);
  if (bytes.empty()) {
    colors.objection = "CMYK without an ICC profile, which does not say what its inks look like";
    return colors;
  }
  const auto profile = readIccProfile(bytes, place);
  if (!profile) {
    colors.objection = "CMYK, but its ICC profile cannot be used (" + profile.error().message + ")";
    return colors;
  }
  if (profile.value().kind != ProfileKind::cmyk) {
    colors.objection = "CMYK, but its ICC profile is for other colours";
    return colors;
  }
  colors.name = "CMYK with the ICC profile '" + profile.value().description + "'";
  colors.toLinearRec709 = profile.value().inksToLinearRec709;
  return colors;
}

}  // namespace

std::string_view iccProfileBytes(const OIIO::ImageSpec& spec) {
  const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile");
  if (profile == nullptr) return {};
  return {static_cast<const char*>(profile->data()), static_cast<std::size_t>(profile->datasize())};
}

bool needsRawColors(ImageFileKind kind, const OIIO::ImageSpec& spec) {
  if (kind != ImageFileKind::tiff) return false;
  const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation");
  return photometric == kSeparated || (photometric >= kCieLab && photometric <= kItuLab);
}

void nameUndeclared(ImageFileKind kind, OIIO::ImageSpec& spec) {
  const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
  const bool isGrey = photometric == 0 || photometric == 1;  // of white or of black as 0
  if (kind != ImageFileKind::tiff || !isGrey || spec.nchannels != 2 || spec.alpha_channel >= 0)
    return;
  spec.channelnames = {"Y", "undeclared"};
}

std::optional<StoredColors> storedColorsOf(ImageFileKind kind, const OIIO::ImageSpec& spec,
                                           const std::string& place) {
  if (kind == ImageFileKind::jpeg && isInkJpeg(spec)) return inkColors(spec, place);
  if (kind != ImageFileKind::tiff) return std::nullopt;
  const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation");
  if (photometric == kSeparated) {
    if (spec.get_string_attribute("tiff:ColorSpace") == "CMYK") return inkColors(spec, place);
    return StoredColors{"inks", 3, {}, "inks that are not CMYK"};
  }
  if (photometric == kItuLab) return StoredColors{"ITU Lab", 3, {}, "CIELab in the way of faxes"};
  if (photometric != kCieLab && photometric != kIccLab) return std::nullopt;
  if (spec.nchannels < 3) return StoredColors{"CIELab", 3, {}, "CIELab without its colours"};
  return labColors(photometric, spec);
}

}  // namespace cutis
