#include "src/color/matrix_space.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "core/base/number_text.h"
#include "core/spectra/rgb_primaries.h"
#include "src/color/builtin_space.h"

namespace cutis {
namespace {

constexpr int kGridSteps = 16;
// Profiles store numbers to 1 / 65536 and curves in samples.
constexpr double kSameSpace = 5e-4;

void multiply(const Eigen::Matrix3d& matrix, std::span<float> rgb) {
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    const Eigen::Vector3d out = matrix * Eigen::Vector3d(rgb[i], rgb[i + 1], rgb[i + 2]);
    for (std::size_t k = 0; k < 3; ++k) {
      rgb[i + k] = static_cast<float>(out[static_cast<Eigen::Index>(k)]);
    }
  }
}

ColorConverter toLinear(const std::shared_ptr<const ColorMatrix>& space) {
  const bool adapts = !space->toRec709.isIdentity(0.0), curved = !space->isLinear();
  return [space, adapts, curved](std::span<float> rgb) -> Status {
    for (std::size_t i = 0; curved && i < rgb.size(); ++i)
      rgb[i] = static_cast<float>(space->curves[i % 3].toLight(rgb[i]));
    if (adapts) multiply(space->toRec709, rgb);
    return {};
  };
}

ColorConverter fromLinear(const std::shared_ptr<const ColorMatrix>& space) {
  const bool adapts = !space->toRec709.isIdentity(0.0), curved = !space->isLinear();
  const Eigen::Matrix3d inverse = space->toRec709.inverse();
  return [space, adapts, curved, inverse](std::span<float> rgb) -> Status {
    if (adapts) multiply(inverse, rgb);
    for (std::size_t i = 0; curved && i < rgb.size(); ++i)
      rgb[i] = static_cast<float>(space->curves[i % 3].fromLight(rgb[i]));
    return {};
  };
}

std::vector<float> grid() {
  std::vector<float> rgb;
  for (int i = 0; i <= kGridSteps; ++i) {
    for (int j = 0; j <= kGridSteps; ++j) {
      for (int k = 0; k <= kGridSteps; ++k) {
        for (const int step : {i, j, k})
          rgb.push_back(static_cast<float>(step) / kGridSteps);
      }
    }
  }
  return rgb;
}

// As people call them; empty where they have no name. Spaces of one name are one space, so that
// nothing is taken for what it only resembles.
std::string nameOfPrimaries(const std::array<double, 8>& chromaticities) {
  constexpr double kSamePlace = 5e-5;
  using Known = std::pair<const char*, std::array<double, 8>>;
  static const std::array<Known, 10> known = {
      {{"Rec.709", kRec709.chromaticities},
       {"Rec.2020", kRec2020.chromaticities},
       {"P3-D65", kP3D65.chromaticities},
       {"DCI-P3", {0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.314, 0.351}},
       {"Adobe RGB", kAdobeRgb.chromaticities},
       {"ACES AP0", kAces2065.chromaticities},
       {"ACES AP1", kAcesCg.chromaticities},
       {"SMPTE-C", {0.630, 0.340, 0.310, 0.595, 0.155, 0.070, 0.3127, 0.3290}},
       {"XYZ under E", {1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0 / 3.0, 1.0 / 3.0}},
       {"XYZ under D65", {1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.3127, 0.3290}}}};
  const auto found = std::find_if(known.begin(), known.end(), [&](const Known& entry) {
    return std::equal(chromaticities.begin(), chromaticities.end(), entry.second.begin(),
                      [](double a, double b) { return std::abs(a - b) <= kSamePlace; });
  });
  return found == known.end() ? "" : found->first;
}

std::string descriptionOf(const std::array<double, 8>& chromaticities, const TransferCurve& curve) {
  std::string text = curve.isLinear() ? "linear" : "curved";
  if (!curve.formulaName().empty()) text = curve.formulaName();
  if (const auto p = curve.parameters(); p && *p == TransferCurve::Parameters{.g = p->g}) {
    text = p->g == 1.0 ? "linear" : "gamma " + formatNumber(p->g, 4);
  }
  text += " RGB of the primaries";
  if (const std::string known = nameOfPrimaries(chromaticities); !known.empty())
    return text + " of " + known;
  for (const double value : chromaticities)
    text += " " + formatNumber(value, 4);
  return text;
}

}  // namespace

bool ColorMatrix::isLinear() const {
  return std::all_of(curves.begin(), curves.end(),
                     [](const TransferCurve& curve) { return curve.isLinear(); });
}

ColorSpace matrixSpace(std::string name, ColorMatrix matrix) {
  const auto shared = std::make_shared<const ColorMatrix>(std::move(matrix));
  ColorSpace space;
  space.name = std::move(name);
  space.toLinearRec709 = toLinear(shared);
  space.fromLinearRec709 = fromLinear(shared);
  space.matrix = shared;
  return space;
}

double differenceOf(const ColorSpace& a, const ColorSpace& b) {
  std::vector<float> first = grid(), second = first;
  if (!a.toLinearRec709(first) || !b.toLinearRec709(second)) return INFINITY;
  double largest = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double difference = std::abs(double{first[i]} - second[i]);
    if (std::isnan(difference)) return INFINITY;
    largest = std::max(largest, difference);
  }
  return largest;
}

ColorSpace inNarrowRange(const ColorSpace& space, double black, double white) {
  ColorMatrix matrix = *space.matrix;
  for (TransferCurve& curve : matrix.curves)
    curve = curve.between(black, white);
  return matrixSpace(space.name + ", narrow range", std::move(matrix));
}

ColorSpace builtInLike(const ColorSpace& space) {
  for (const std::string& name : builtInSpaceNames()) {
    const ColorSpace& known = builtInColorSpace(name);
    if (differenceOf(space, known) <= kSameSpace) return known;
  }
  return {};
}

Result<ColorSpace> spaceOfPrimaries(const std::array<double, 8>& chromaticities,
                                    const std::array<TransferCurve, 3>& curves,
                                    const std::string& place) {
  const auto finite = [](double v) { return std::isfinite(v) && std::abs(v) < 1e3; };
  const RgbPrimaries primaries = {"", chromaticities};
  const bool sane =
      std::all_of(chromaticities.begin(), chromaticities.end(), finite) && chromaticities[7] > 1e-3;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  if (sane) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(2 * k);
      corners.col(k) << chromaticities[at], chromaticities[at + 1], 1.0;
    }
    if (std::abs(corners.determinant()) > kLeastDeterminant)
      matrix = rgbFromRgb(kRec709, primaries);
  }
  if (!matrix.allFinite() || std::abs(matrix.determinant()) < kLeastDeterminant) {
    return inputError(place,
                      "the primaries and the white that the file states span no colours; name "
                      "its colour space");
  }
  ColorMatrix space = {curves, matrix, chromaticities};
  ColorSpace made = matrixSpace(descriptionOf(chromaticities, curves.front()), std::move(space));
  ColorSpace known = builtInLike(made);
  return known.empty() ? made : known;
}

Result<ColorSpace> spaceOfPrimaries(const std::array<double, 8>& chromaticities,
                                    const TransferCurve& curve, const std::string& place) {
  return spaceOfPrimaries(chromaticities, std::array{curve, curve, curve}, place);
}

}  // namespace cutis
