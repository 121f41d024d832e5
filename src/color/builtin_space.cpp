#include "src/color/builtin_space.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <string_view>
#include <utility>

#include <Eigen/Core>

#include "core/spectra/rgb_primaries.h"
#include "src/color/matrix_space.h"
#include "src/color/video_curve.h"

namespace cutis {
namespace {

struct Space {
  std::string_view name;
  const RgbPrimaries* primaries;  // null: numbers are taken as they are
  TransferCurve curve;
  // Other spellings, already without separators.
  std::vector<std::string_view> aliases;
};

const std::vector<Space>& spaces() {
  static const std::vector<Space> all = {
      {"sRGB",
       &kRec709,
       TransferCurve::srgb(),
       {"srgbencodedrec709srgb", "srgbrec709scene", "srgbtexture", "utilitysrgbtexture", "srgbtx",
        "srgbdisplay", "srgbiec6196621"}},
      {"Linear Rec.709",
       &kRec709,
       TransferCurve(),
       {"linrec709", "linsrgb", "linear", "rec709linear", "linearsrgb", "srgblinear",
        "linearrec709srgb", "utilitylinearsrgb", "utilitylinearrec709", "linrec709scene",
        "scenelinearrec709srgb"}},
      {"ACEScg", &kAcesCg, TransferCurve(), {"acesacescg", "linap1", "linap1scene", "ap1"}},
      {"ACES2065-1",
       &kAces2065,
       TransferCurve(),
       {"acesaces20651", "linap0", "linap0scene", "ap0", "aces"}},
      {"Linear Rec.2020",
       &kRec2020,
       TransferCurve(),
       {"linrec2020", "linrec2020scene", "utilitylinearrec2020"}},
      {"Linear P3-D65",
       &kP3D65,
       TransferCurve(),
       {"linp3d65", "linp3d65scene", "lineardisplayp3", "utilitylinearp3d65"}},
      {"Display P3",
       &kP3D65,
       TransferCurve::srgb(),
       {"p3display", "srgbp3d65", "srgbp3d65scene", "srgbencodedp3d65"}},
      {"Adobe RGB (1998)",
       &kAdobeRgb,
       TransferCurve::power(563.0 / 256.0),
       {"adobergb", "adobergb1998compatible", "g22adobergb"}},
      {"Gamma 2.2 Rec.709",
       &kRec709,
       TransferCurve::power(2.2),
       {"gamma22", "gammacorrected22", "g22rec709", "g22rec709scene", "gamma22encodedrec709"}},
      {"Rec.2100 PQ",
       &kRec2020,
       pqCurve(),
       {"rec2100pqdisplay", "rec2020pq", "pqrec2020", "pqrec2020display", "st2084rec2020"}},
      {"Rec.2100 HLG",
       &kRec2020,
       hlgCurve(),
       {"rec2100hlgdisplay", "rec2020hlg", "hlgrec2020", "hlgrec2020display"}},
      {"Raw", nullptr, TransferCurve(), {"none", "data", "utilityraw"}},
  };
  return all;
}

// "Linear Rec.709 (sRGB)" → "linearrec709srgb"
std::string withoutSeparators(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0) plain += static_cast<char>(std::tolower(letter));
  }
  return plain;
}

ColorSpace madeOf(const Space& space) {
  ColorMatrix matrix = {{space.curve, space.curve, space.curve}, Eigen::Matrix3d::Identity(), {}};
  if (space.primaries != nullptr) matrix.chromaticities = space.primaries->chromaticities;
  if (space.primaries != nullptr && space.primaries != &kRec709)
    matrix.toRec709 = rgbFromRgb(kRec709, *space.primaries);
  ColorSpace made = matrixSpace(std::string(space.name), std::move(matrix));
  made.isNamed = true;
  return made;
}

}  // namespace

std::optional<int> builtInSpace(const std::string& name) {
  const std::string plain = withoutSeparators(name);
  for (std::size_t i = 0; i < spaces().size(); ++i) {
    const auto& aliases = spaces()[i].aliases;
    if (plain == withoutSeparators(spaces()[i].name) ||
        std::find(aliases.begin(), aliases.end(), plain) != aliases.end()) {
      return static_cast<int>(i);
    }
  }
  return std::nullopt;
}

std::vector<std::string> builtInSpaceNames() {
  std::vector<std::string> names;
  for (const Space& space : spaces())
    names.emplace_back(space.name);
  return names;
}

const ColorSpace& builtInSpaceAt(int index) {
  static const std::vector<ColorSpace> made = [] {
    std::vector<ColorSpace> all;
    for (const Space& space : spaces())
      all.push_back(madeOf(space));
    return all;
  }();
  return made[static_cast<std::size_t>(index)];
}

const ColorSpace& builtInColorSpace(const std::string& name) {
  const auto index = builtInSpace(name);
  assert(index.has_value());
  return builtInSpaceAt(*index);
}

}  // namespace cutis
