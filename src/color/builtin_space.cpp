#include "src/color/builtin_space.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

#include <Eigen/Core>

#include "core/spectra/rgb_primaries.h"

namespace cutis {
namespace {

enum class Curve { linear, srgb, power };

struct Space {
  std::string_view name;
  const RgbPrimaries* primaries;  // null: numbers are taken as they are
  Curve curve;
  double exponent;  // of Curve::power
  // Other spellings, already without separators.
  std::vector<std::string_view> aliases;
};

const std::vector<Space>& spaces() {
  static const std::vector<Space> all = {
      {"sRGB",
       &kRec709,
       Curve::srgb,
       0.0,
       {"srgbencodedrec709srgb", "srgbrec709scene", "srgbtexture", "utilitysrgbtexture", "srgbtx",
        "srgbdisplay", "srgbiec6196621"}},
      {"Linear Rec.709",
       &kRec709,
       Curve::linear,
       0.0,
       {"linrec709", "linsrgb", "linear", "rec709linear", "linearsrgb", "srgblinear",
        "linearrec709srgb", "utilitylinearsrgb", "utilitylinearrec709", "linrec709scene",
        "scenelinearrec709srgb"}},
      {"ACEScg", &kAcesCg, Curve::linear, 0.0, {"acesacescg", "linap1", "linap1scene", "ap1"}},
      {"ACES2065-1",
       &kAces2065,
       Curve::linear,
       0.0,
       {"acesaces20651", "linap0", "linap0scene", "ap0", "aces"}},
      {"Linear Rec.2020",
       &kRec2020,
       Curve::linear,
       0.0,
       {"linrec2020", "linrec2020scene", "utilitylinearrec2020"}},
      {"Linear P3-D65",
       &kP3D65,
       Curve::linear,
       0.0,
       {"linp3d65", "linp3d65scene", "lineardisplayp3", "utilitylinearp3d65"}},
      {"Display P3",
       &kP3D65,
       Curve::srgb,
       0.0,
       {"p3display", "srgbp3d65", "srgbp3d65scene", "srgbencodedp3d65"}},
      {"Adobe RGB (1998)",
       &kAdobeRgb,
       Curve::power,
       563.0 / 256.0,
       {"adobergb", "adobergb1998compatible", "g22adobergb"}},
      {"Gamma 2.2 Rec.709",
       &kRec709,
       Curve::power,
       2.2,
       {"gamma22", "gammacorrected22", "g22rec709", "g22rec709scene", "gamma22encodedrec709"}},
      {"Raw", nullptr, Curve::linear, 0.0, {"none", "data", "utilityraw"}},
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

// IEC 61966-2-1; the curves of core/spectra in single precision.
float decodedSrgb(float value) {
  const float y = std::abs(value);
  const float x = y <= 0.04045f ? y / 12.92f : std::pow((y + 0.055f) / 1.055f, 2.4f);
  return std::copysign(x, value);
}
float encodedSrgb(float value) {
  const float x = std::abs(value);
  const float y = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
  return std::copysign(y, value);
}

float decoded(const Space& space, float value) {
  if (space.curve == Curve::srgb) return decodedSrgb(value);
  return std::copysign(std::pow(std::abs(value), static_cast<float>(space.exponent)), value);
}
float encoded(const Space& space, float value) {
  if (space.curve == Curve::srgb) return encodedSrgb(value);
  return std::copysign(std::pow(std::abs(value), static_cast<float>(1.0 / space.exponent)), value);
}

void multiply(const Eigen::Matrix3d& matrix, std::span<float> rgb) {
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    const Eigen::Vector3d out = matrix * Eigen::Vector3d(rgb[i], rgb[i + 1], rgb[i + 2]);
    for (std::size_t k = 0; k < 3; ++k) {
      rgb[i + k] = static_cast<float>(out[static_cast<Eigen::Index>(k)]);
    }
  }
}

const Space& spaceAt(int index) {
  return spaces()[static_cast<std::size_t>(index)];
}

bool isRec709(const Space& space) {
  return space.primaries == nullptr || space.primaries == &kRec709;
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

std::string builtInSpaceName(int index) {
  return std::string(spaceAt(index).name);
}

std::vector<std::string> builtInSpaceNames() {
  std::vector<std::string> names;
  for (const Space& space : spaces())
    names.emplace_back(space.name);
  return names;
}

ColorConverter builtInToLinearRec709(int index) {
  const Space& space = spaceAt(index);
  const bool adapts = !isRec709(space);
  const Eigen::Matrix3d matrix =
      adapts ? rgbFromRgb(kRec709, *space.primaries) : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  return [&space, adapts, matrix](std::span<float> rgb) -> Status {
    if (space.curve != Curve::linear) {
      for (float& value : rgb)
        value = decoded(space, value);
    }
    if (adapts) multiply(matrix, rgb);
    return {};
  };
}

ColorConverter builtInFromLinearRec709(int index) {
  const Space& space = spaceAt(index);
  const bool adapts = !isRec709(space);
  const Eigen::Matrix3d matrix =
      adapts ? rgbFromRgb(*space.primaries, kRec709) : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  return [&space, adapts, matrix](std::span<float> rgb) -> Status {
    if (adapts) multiply(matrix, rgb);
    if (space.curve != Curve::linear) {
      for (float& value : rgb)
        value = encoded(space, value);
    }
    return {};
  };
}

}  // namespace cutis
