#pragma once

// Colour from spectra, and distances between colours. CIE 15:2018 (Colorimetry), IEC 61966-2-1
// (sRGB), ITU-R BT.709; CIEDE2000 after Sharma, Wu, Dalal 2005. Pure functions; NaN in, NaN out.

#include <Eigen/Core>

#include "core/spectra/grid.h"

namespace cutis {

// Three curves of a colour-matching observer or of a camera: X, Y, Z or R, G, B. Relative units.
struct Sensor {
  Eigen::Array<double, 3, kSampleCount, Eigen::RowMajor> sensitivity;
};

// Tristimulus values of a perfect diffuser under a light, Y = 1.
Eigen::Vector3d whitePoint(const Spectrum& light, const Sensor& observer);

// The three rows that, applied to a reflectance spectrum, give its tristimulus values with Y = 1
// for a perfect diffuser under the light.
SpectrumRows tristimulusRows(const Spectrum& light, const Sensor& observer);

// The three channels of a camera under a light, each 1 for a perfect diffuser; a channel that sees
// nothing, or less than 1e-9 of the light, is all zero.
SpectrumRows channelRows(const Spectrum& light, const Sensor& camera);

// Linear Rec.709 to XYZ and back, for a given white: RGB (1, 1, 1) is exactly that white. With the
// white of D65 on our grid it agrees with the matrices of IEC 61966-2-1 to 2e-4, and a perfect
// diffuser under D65 is exactly (1, 1, 1).
Eigen::Matrix3d xyzFromRec709(const Eigen::Vector3d& white);

// CIELAB; `white` is the tristimulus of the perfect diffuser.
Eigen::Vector3d labFromXyz(const Eigen::Vector3d& xyz, const Eigen::Vector3d& white);
// L* alone of a relative luminance (perfect diffuser = 1).
double lightness(double relativeLuminance);

double deltaE2000(const Eigen::Vector3d& lab1, const Eigen::Vector3d& lab2);

// Individual typology angle in degrees: atan((L* − 50) / b*), Chardon et al. 1991.
double individualTypologyAngle(const Eigen::Vector3d& lab);

enum class ChromaticAdaptation { none, bradford, cat16 };

// XYZ under white `from` to the corresponding XYZ under white `to` (complete von Kries adaptation
// in the cone space of the transform).
Eigen::Matrix3d adaptationMatrix(ChromaticAdaptation transform, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to);

// The sRGB transfer curve, extended oddly below 0 and without an upper limit.
double encodeSrgb(double linear);
double decodeSrgb(double encoded);

}  // namespace cutis
