#pragma once

// Primaries and white points of the linear RGB spaces that picture files use, as CIE 1931 x, y.
// ITU-R BT.709-6 and BT.2020-2, SMPTE EG 432-1 (P3-D65), SMPTE ST 2065-1 (ACES2065-1) and Academy
// S-2014-004 (ACEScg), Adobe RGB (1998) 2005-05.

#include <array>
#include <string_view>

#include <Eigen/LU>

#include "core/spectra/colorimetry.h"

namespace cutis {

struct RgbPrimaries {
  // The name of the colour space that is linear in these primaries.
  std::string_view name;
  // x, y of red, green, blue and white: the order of the EXR attribute `chromaticities`.
  std::array<double, 8> chromaticities;

  Eigen::Vector3d xyzOfWhite() const {
    const double x = chromaticities[6], y = chromaticities[7];
    return {x / y, 1.0, (1.0 - x - y) / y};
  }
};

inline constexpr RgbPrimaries kRec709 = {"Linear Rec.709",
                                         {0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290}};
inline constexpr RgbPrimaries kAces2065 = {
    "ACES2065-1", {0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.077, 0.32168, 0.33767}};
inline constexpr RgbPrimaries kAcesCg = {
    "ACEScg", {0.713, 0.293, 0.165, 0.830, 0.128, 0.044, 0.32168, 0.33767}};
inline constexpr RgbPrimaries kRec2020 = {
    "Linear Rec.2020", {0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290}};
inline constexpr RgbPrimaries kP3D65 = {"Linear P3-D65",
                                        {0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290}};
inline constexpr RgbPrimaries kAdobeRgb = {"Linear Adobe RGB",
                                           {0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.3290}};

// XYZ with Y = 1 for RGB (1, 1, 1); no adaptation.
inline Eigen::Matrix3d xyzFromRgb(const RgbPrimaries& rgb) {
  Eigen::Matrix3d primaries;  // columns: XYZ of R, G, B at unit x + y + z
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(2 * k);
    const double x = rgb.chromaticities[at], y = rgb.chromaticities[at + 1];
    primaries.col(k) << x, y, 1.0 - x - y;
  }
  const Eigen::Vector3d scale = primaries.inverse() * rgb.xyzOfWhite();
  return primaries * scale.asDiagonal();
}

// The matrix from one linear RGB space to another, white onto white (Bradford), as the ACES and
// OpenColorIO matrices do it.
inline Eigen::Matrix3d rgbFromRgb(const RgbPrimaries& to, const RgbPrimaries& from) {
  return xyzFromRgb(to).inverse() *
         adaptationMatrix(ChromaticAdaptation::bradford, from.xyzOfWhite(), to.xyzOfWhite()) *
         xyzFromRgb(from);
}

}  // namespace cutis
