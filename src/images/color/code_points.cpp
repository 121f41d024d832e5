#include "src/images/color/code_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/word_list.h"
#include "src/color/video_curve.h"

namespace cutis {
namespace {

using Chromaticities = std::array<double, 8>;

// H.273, table 3.
constexpr int kPq = 16, kHlg = 18;

// H.273, table 2.
std::optional<Chromaticities> primariesOf(int code) {
  switch (code) {
    case 1:
      return Chromaticities{0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};
    case 4:
      return Chromaticities{0.67, 0.33, 0.21, 0.71, 0.14, 0.08, 0.310, 0.316};
    case 5:
      return Chromaticities{0.64, 0.33, 0.29, 0.60, 0.15, 0.06, 0.3127, 0.3290};
    case 6:
    case 7:
      return Chromaticities{0.630, 0.340, 0.310, 0.595, 0.155, 0.070, 0.3127, 0.3290};
    case 8:
      return Chromaticities{0.681, 0.319, 0.243, 0.692, 0.145, 0.049, 0.310, 0.316};
    case 9:
      return Chromaticities{0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290};
    case 10:
      return Chromaticities{1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0 / 3.0, 1.0 / 3.0};
    case 11:
      return Chromaticities{0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.314, 0.351};
    case 12:
      return Chromaticities{0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290};
    case 22:
      return Chromaticities{0.630, 0.340, 0.295, 0.605, 0.155, 0.077, 0.3127, 0.3290};
    default:
      return std::nullopt;
  }
}

// H.273, table 3: the inverse of what a camera does.
std::optional<TransferCurve> curveOf(int code) {
  constexpr double kAlpha = 1.09929682680944, kBeta = 0.018053968510807;
  switch (code) {
    case 1:
    case 6:
    case 11:
    case 12:
    case 14:
    case 15:
      return TransferCurve::parametric({.g = 1.0 / 0.45,
                                        .a = 1.0 / kAlpha,
                                        .b = (kAlpha - 1.0) / kAlpha,
                                        .c = 1.0 / 4.5,
                                        .d = 4.5 * kBeta});
    case 4:
      return TransferCurve::power(2.2);
    case 5:
      return TransferCurve::power(2.8);
    case 7:
      return TransferCurve::parametric({.g = 1.0 / 0.45,
                                        .a = 1.0 / 1.1115,
                                        .b = 0.1115 / 1.1115,
                                        .c = 1.0 / 4.0,
                                        .d = 4.0 * 0.0228});
    case 8:
      return TransferCurve();
    case 9:
    case 10:
      return logarithmicCurve(code == 10);
    case 13:
      return TransferCurve::srgb();
    case kPq:
      return pqCurve();
    case 17:
      return TransferCurve::parametric({.g = 2.6, .a = std::pow(52.37 / 48.0, 1.0 / 2.6)});
    case kHlg:
      return hlgCurve();
    default:
      return std::nullopt;
  }
}

// What the numbers of black and white are in the narrow range (H.273, equations 20 to 22).
struct Range {
  double black = 0.0;
  double white = 1.0;
};
Range rangeOf(bool isFull, int bits) {
  if (isFull) return {};
  const double step = std::ldexp(1.0, bits - 8) / (std::ldexp(1.0, bits) - 1.0);
  return {16.0 * step, 235.0 * step};
}

std::string assumptionOf(const CodePoints& points) {
  std::vector<std::string> parts;
  if (points.transfer == kPq) parts.emplace_back("light of 203 cd/m² is taken as 1");
  if (points.transfer == kHlg)
    parts.emplace_back("the scene's light at the signal 0.75 is taken as 1");
  if (!points.fullRange) parts.emplace_back("the narrow range of video is expanded");
  return wordList(parts, " and ");
}

bool isSameCurve(const TransferCurve& a, const TransferCurve& b) {
  constexpr int kPlaces = 32;
  for (int i = 0; i <= kPlaces; ++i) {
    const double number = static_cast<double>(i) / kPlaces;
    if (std::abs(a.toLight(number) - b.toLight(number)) > 1e-9) return false;
  }
  return true;
}

bool isSamePlace(const Chromaticities& a, const Chromaticities& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double u, double v) { return std::abs(u - v) < 1e-9; });
}

// Colour spaces as the Color Interop Forum names them.
struct InteropId {
  std::string_view id;
  const char* space;
};

constexpr std::array<InteropId, 12> kInteropIds = {{{"lin_ap1_scene", "ACEScg"},
                                                    {"lin_ap0_scene", "ACES2065-1"},
                                                    {"lin_rec709_scene", "Linear Rec.709"},
                                                    {"lin_p3d65_scene", "Linear P3-D65"},
                                                    {"lin_rec2020_scene", "Linear Rec.2020"},
                                                    {"srgb_rec709_scene", "sRGB"},
                                                    {"srgb_rec709_display", "sRGB"},
                                                    {"srgb_p3d65_scene", "Display P3"},
                                                    {"srgb_p3d65_display", "Display P3"},
                                                    {"g22_rec709_scene", "Gamma 2.2 Rec.709"},
                                                    {"g22_rec709_display", "Gamma 2.2 Rec.709"},
                                                    {"data", "Raw"}}};

// Those that have no name here: primaries and exponent.
std::optional<std::pair<Chromaticities, TransferCurve>> unnamedInterop(const std::string& id) {
  constexpr Chromaticities kAdobe = {0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.3290};
  constexpr Chromaticities kAp1 = {0.713, 0.293, 0.165, 0.830, 0.128, 0.044, 0.32168, 0.33767};
  constexpr Chromaticities kXyz = {1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.3127, 0.3290};
  const auto rec709 = primariesOf(1).value(), p3 = primariesOf(12).value();
  if (id == "lin_adobergb_scene") return std::pair(kAdobe, TransferCurve());
  if (id == "g22_adobergb_scene" || id == "g22_adobergb_display")
    return std::pair(kAdobe, TransferCurve::power(563.0 / 256.0));
  if (id == "lin_ciexyzd65_scene" || id == "lin_ciexyzd65_display")
    return std::pair(kXyz, TransferCurve());
  if (id == "g18_rec709_scene") return std::pair(rec709, TransferCurve::power(1.8));
  if (id == "g24_rec709_display") return std::pair(rec709, TransferCurve::power(2.4));
  if (id == "g26_p3d65_display") return std::pair(p3, TransferCurve::power(2.6));
  if (id == "srgb_ap1_scene") return std::pair(kAp1, TransferCurve::srgb());
  if (id == "g22_ap1_scene") return std::pair(kAp1, TransferCurve::power(2.2));
  return std::nullopt;
}

void follow(const Chromaticities& primaries, const TransferCurve& curve,
            ColorStatement& statement) {
  statement.space = spaceOfPrimaries(primaries, curve, "").value();
}

}  // namespace

ColorStatement statementOf(const CodePoints& points, int bits, const std::string& origin) {
  ColorStatement statement = {ColorSource::codePoints, origin, {}, {}};
  constexpr int kUnspecified = 2;
  const auto primaries = primariesOf(points.primaries);
  const auto curve = curveOf(points.transfer);
  if (points.primaries == kUnspecified || points.transfer == kUnspecified) return statement;
  if (points.matrix != 0) {
    statement.objection = "says luminance and chroma, which PNG files cannot hold";
  } else if (!curve) {
    statement.objection = "says the transfer characteristics " + std::to_string(points.transfer) +
                          ", which are not known";
  } else if (!primaries) {
    statement.objection =
        "says the primaries " + std::to_string(points.primaries) + ", which are not known";
  } else {
    follow(*primaries, *curve, statement);
    const Range range = rangeOf(points.fullRange, bits);
    if (!points.fullRange)
      statement.space = inNarrowRange(statement.space, range.black, range.white);
    statement.assumption = assumptionOf(points);
  }
  return statement;
}

std::optional<CodePoints> codePointsOf(const ColorSpace& space, int bits) {
  if (!space.matrix || !space.matrix->chromaticities) return std::nullopt;
  const std::array<TransferCurve, 3>& curves = space.matrix->curves;
  if (!isSameCurve(curves[0], curves[1]) || !isSameCurve(curves[0], curves[2])) return std::nullopt;
  for (const int primaries : {1, 9, 12}) {
    if (!isSamePlace(*primariesOf(primaries), *space.matrix->chromaticities)) continue;
    for (const int transfer : {1, 8, 13, kPq, kHlg}) {
      for (const bool isFull : {true, false}) {
        const Range range = rangeOf(isFull, bits);
        if (isSameCurve(curveOf(transfer)->between(range.black, range.white), curves[0]))
          return CodePoints{primaries, transfer, 0, isFull};
      }
    }
  }
  return std::nullopt;
}

ColorStatement statementOfInteropId(const std::string& id, const std::string& origin) {
  ColorStatement statement = {ColorSource::interopId, origin, {}, {}};
  for (const InteropId& known : kInteropIds) {
    if (id == known.id) statement.space = builtInColorSpace(known.space);
  }
  if (!statement.space.empty() || id.empty() || id == "unknown") return statement;
  if (const auto unnamed = unnamedInterop(id))
    follow(unnamed->first, unnamed->second, statement);
  else
    statement.objection = "says '" + id.substr(0, 80) + "', which is not known";
  return statement;
}

}  // namespace cutis
