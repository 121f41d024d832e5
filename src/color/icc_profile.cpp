#include "src/color/icc_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <lcms2.h>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "core/spectra/colorimetry.h"
#include "core/spectra/rgb_primaries.h"
#include "src/color/icc_header.h"
#include "src/color/icc_table.h"
#include "src/color/matrix_space.h"

namespace cutis {
namespace {

constexpr std::size_t kLongestDescription = 80;
constexpr int kGreySamples = 4096;

std::string descriptionOf(cmsHPROFILE profile) {
  std::vector<char> text(1024, '\0');
  cmsGetProfileInfoASCII(profile, cmsInfoDescription, "en", "US", text.data(),
                         static_cast<cmsUInt32Number>(text.size() - 1));
  std::string line(text.data());
  std::erase_if(line, [](unsigned char c) { return c < 0x20 || c > 0x7e; });
  return line.substr(0, kLongestDescription);
}

TransferCurve curveOf(const cmsToneCurve* tone) {
  using Parameters = TransferCurve::Parameters;
  const double* p = cmsGetToneCurveParams(tone);
  // LittleCMS counts from 1; ICC.1:2022, table 68.
  switch (p != nullptr ? cmsGetToneCurveParametricType(tone) : 0) {
    case 1:
      return TransferCurve::power(p[0]);
    case 2:
      return TransferCurve::parametric(
          Parameters{.g = p[0], .a = p[1], .b = p[2], .d = -p[2] / p[1]});
    case 3:
      return TransferCurve::parametric(
          Parameters{.g = p[0], .a = p[1], .b = p[2], .d = -p[2] / p[1], .e = p[3], .f = p[3]});
    case 4:
      return TransferCurve::parametric(
          Parameters{.g = p[0], .a = p[1], .b = p[2], .c = p[3], .d = p[4]});
    case 5:
      return TransferCurve::parametric(
          Parameters{.g = p[0], .a = p[1], .b = p[2], .c = p[3], .d = p[4], .e = p[5], .f = p[6]});
    default:
      break;
  }
  const cmsUInt32Number count = cmsGetToneCurveEstimatedTableEntries(tone);
  const cmsUInt16Number* table = cmsGetToneCurveEstimatedTable(tone);
  std::vector<double> light;
  for (cmsUInt32Number i = 0; i < count; ++i)
    light.push_back(table[i] / 65535.0);
  if (light.size() < 2) return {};
  return TransferCurve::sampled(std::move(light));
}

bool hasTable(cmsHPROFILE profile) {
  for (const cmsTagSignature tag :
       {cmsSigAToB0Tag, cmsSigAToB1Tag, cmsSigAToB2Tag, cmsSigDToB0Tag, cmsSigDToB1Tag}) {
    if (cmsIsTag(profile, tag)) return true;
  }
  return false;
}

// From XYZ under D50, where profiles meet, to linear Rec.709.
Eigen::Matrix3d rec709FromD50() {
  const Eigen::Vector3d d50(cmsD50_XYZ()->X, cmsD50_XYZ()->Y, cmsD50_XYZ()->Z);
  return xyzFromRgb(kRec709).inverse() *
         adaptationMatrix(ChromaticAdaptation::bradford, d50, kRec709.xyzOfWhite());
}

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& place) : bytes_(bytes), place_(place) {}

  Result<IccProfile> read() {
    if (bytes_.size() > kLargestProfileBytes) return refused("it is larger than 16 MiB");
    library_ = std::make_shared<IccLibrary>();
    profile_ = library_->open(bytes_);
    if (profile_ == nullptr) return refused(whyItDoesNotOpen());
    description_ = descriptionOf(profile_);
    switch (cmsGetColorSpace(profile_)) {
      case cmsSigRgbData:
        return hasTable(profile_) ? table(ProfileKind::rgb) : matrix();
      case cmsSigGrayData:
        return grey();
      case cmsSigCmykData:
        return table(ProfileKind::cmyk);
      case cmsSigLabData:
        return IccProfile{ProfileKind::lab, description_, {}, {}};
      default:
        return refused("it describes neither RGB, grey, CMYK nor CIELab");
    }
  }

 private:
  Error refused(const std::string& reason) const { return inputError(place_, reason); }

  // Shorter than its header says, or than a header (ICC.1:2022, §7.2).
  bool isCutOff() const {
    std::size_t length = 0;
    for (const char byte : bytes_.substr(0, 4))
      length = length << 8 | static_cast<unsigned char>(byte);
    return bytes_.size() < std::max(length, kIccHeaderBytes);
  }

  std::string whyItDoesNotOpen() const {
    constexpr std::size_t kMarkAt = 36;
    if (bytes_.empty()) return "it cannot be unpacked";
    if (bytes_.size() >= kIccHeaderBytes && bytes_.substr(kMarkAt, 4) != "acsp")
      return "it does not begin like an ICC profile";
    return isCutOff() ? "it is cut off" : "it is damaged";
  }

  std::string nameOf() const {
    return description_.empty() ? "the space of an ICC profile without a name"
                                : "the space of the ICC profile '" + description_ + "'";
  }

  // The name of a built-in space where it is one; its own numbers in any case.
  IccProfile named(ColorSpace space, std::string bytes) const {
    const ColorSpace known = builtInLike(space);
    if (!known.empty()) space.name = known.name;
    space.isNamed = !known.empty();
    space.profile = std::make_shared<const std::string>(std::move(bytes));
    return {ProfileKind::rgb, description_, std::move(space), {}};
  }

  Result<IccProfile> matrix() {
    ColorMatrix space;
    Eigen::Matrix3d colorants;
    constexpr std::array<cmsTagSignature, 3> columns = {
        cmsSigRedColorantTag, cmsSigGreenColorantTag, cmsSigBlueColorantTag};
    constexpr std::array<cmsTagSignature, 3> curves = {cmsSigRedTRCTag, cmsSigGreenTRCTag,
                                                       cmsSigBlueTRCTag};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto* xyz = static_cast<const cmsCIEXYZ*>(cmsReadTag(profile_, columns[c]));
      const auto* tone = static_cast<const cmsToneCurve*>(cmsReadTag(profile_, curves[c]));
      if (xyz == nullptr || tone == nullptr)
        return refused(isCutOff() ? "it is cut off"
                                  : "it has neither a matrix with curves nor a table");
      colorants.col(static_cast<Eigen::Index>(c)) << xyz->X, xyz->Y, xyz->Z;
      space.curves[c] = curveOf(tone);
      if (!space.curves[c].isRising()) return refused("a curve of it does not rise");
    }
    space.toRec709 = rec709FromD50() * colorants;
    if (!(std::abs(space.toRec709.determinant()) > kLeastDeterminant))
      return refused("its primaries span no colours");
    return named(matrixSpace(nameOf(), std::move(space)), std::string(bytes_));
  }

  Result<IccProfile> grey() {
    CUTIS_TRY(to, IccTable::open(library_, profile_, 1, rec709FromD50()));
    std::vector<float> numbers, light(3 * kGreySamples);
    for (int i = 0; i < kGreySamples; ++i)
      numbers.push_back(static_cast<float>(i) / (kGreySamples - 1));
    to->toLinear(numbers, light);
    const auto* tone = static_cast<const cmsToneCurve*>(cmsReadTag(profile_, cmsSigGrayTRCTag));
    TransferCurve curve;
    if (tone != nullptr && cmsGetPCS(profile_) == cmsSigXYZData && !hasTable(profile_)) {
      curve = curveOf(tone);
    } else {
      std::vector<double> samples;
      for (std::size_t i = 0; i < light.size(); i += 3)
        samples.push_back(light[i + 1]);
      curve = TransferCurve::sampled(std::move(samples));
    }
    if (!curve.isRising()) return refused("its curve does not rise");
    ColorMatrix space = {
        {curve, curve, curve}, Eigen::Matrix3d::Identity(), kRec709.chromaticities};
    ColorSpace made = matrixSpace(nameOf(), std::move(space));
    const std::string ofColors = iccProfileOf(made);
    IccProfile result = named(std::move(made), ofColors);
    result.kind = ProfileKind::grey;
    return result;
  }

  Result<IccProfile> table(ProfileKind kind) {
    const int channels = kind == ProfileKind::cmyk ? 4 : 3;
    CUTIS_TRY(table, IccTable::open(library_, profile_, channels, rec709FromD50()));
    if (kind == ProfileKind::cmyk) {
      IccProfile result{kind, description_, {}, {}};
      result.inksToLinearRec709 = [table](std::span<const float> inks, std::span<float> rgb) {
        table->toLinear(inks, rgb);
      };
      return result;
    }
    ColorSpace space;
    space.name = nameOf();
    space.toLinearRec709 = [table](std::span<float> rgb) -> Status {
      table->toLinear(rgb, rgb);
      return {};
    };
    space.fromLinearRec709 = [table](std::span<float> rgb) -> Status {
      table->fromLinear(rgb);
      return {};
    };
    space.profile = std::make_shared<const std::string>(bytes_);
    return IccProfile{kind, description_, std::move(space), {}};
  }

  std::string_view bytes_;
  std::string place_;
  std::shared_ptr<IccLibrary> library_;
  cmsHPROFILE profile_ = nullptr;
  std::string description_;
};

}  // namespace

Result<IccProfile> readIccProfile(std::string_view bytes, const std::string& place) {
  return Reader(bytes, place).read();
}

}  // namespace cutis
