#include "core/spectra/colorimetry.h"

#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace cutis {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// CIE 15: (6/29)^3 and its slope.
double labCurve(double ratio) {
  constexpr double threshold = 216.0 / 24389.0;
  return ratio > threshold ? std::cbrt(ratio) : ratio * (841.0 / 108.0) + 4.0 / 29.0;
}

double hueDegrees(double a, double b) {
  if (a == 0.0 && b == 0.0) return 0.0;
  const double degrees = std::atan2(b, a) / kDegree;
  return degrees < 0.0 ? degrees + 360.0 : degrees;
}

Eigen::Matrix3d coneMatrix(ChromaticAdaptation transform) {
  Eigen::Matrix3d m;
  if (transform == ChromaticAdaptation::bradford) {
    m << 0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296;
  } else {
    m << 0.401288, 0.650173, -0.051461, -0.250268, 1.204414, 0.045854, -0.002079, 0.048952,
        0.953127;
  }
  return m;
}

}  // namespace

Eigen::Vector3d whitePoint(const Spectrum& light, const Sensor& observer) {
  const Eigen::Vector3d xyz = (observer.sensitivity.matrix() * light.matrix());
  return xyz / xyz[1];
}

SpectrumRows tristimulusRows(const Spectrum& light, const Sensor& observer) {
  const double luminance = observer.sensitivity.row(1).matrix().dot(light.matrix());
  SpectrumRows rows(3, kSampleCount);
  for (int k = 0; k < 3; ++k) {
    rows.row(k) = observer.sensitivity.row(k) * light.transpose() / luminance;
  }
  return rows;
}

SpectrumRows channelRows(const Spectrum& light, const Sensor& camera) {
  // The far tail of a light at the end of what the camera sees is no measurement.
  constexpr double kVanishing = 1e-9;
  const double most = light.sum() * camera.sensitivity.maxCoeff();
  SpectrumRows rows(3, kSampleCount);
  for (int c = 0; c < 3; ++c) {
    rows.row(c) = camera.sensitivity.row(c) * light.transpose();
    const double sum = rows.row(c).sum();
    if (sum > kVanishing * most) {
      rows.row(c) /= sum;
    } else {
      rows.row(c).setZero();
    }
  }
  return rows;
}

Eigen::Matrix3d xyzFromRec709(const Eigen::Vector3d& white) {
  Eigen::Matrix3d primaries;  // columns: XYZ of R, G, B at unit x + y + z
  primaries << 0.64, 0.30, 0.15, 0.33, 0.60, 0.06, 0.03, 0.10, 0.79;
  const Eigen::Vector3d scale = primaries.inverse() * white;
  return primaries * scale.asDiagonal();
}

Eigen::Vector3d labFromXyz(const Eigen::Vector3d& xyz, const Eigen::Vector3d& white) {
  const double fx = labCurve(xyz[0] / white[0]);
  const double fy = labCurve(xyz[1] / white[1]);
  const double fz = labCurve(xyz[2] / white[2]);
  return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

double lightness(double relativeLuminance) {
  return 116.0 * labCurve(relativeLuminance) - 16.0;
}

double deltaE2000(const Eigen::Vector3d& lab1, const Eigen::Vector3d& lab2) {
  const double chroma1 = std::hypot(lab1[1], lab1[2]);
  const double chroma2 = std::hypot(lab2[1], lab2[2]);
  const double meanChroma7 = std::pow(0.5 * (chroma1 + chroma2), 7.0);
  const double twentyFive7 = std::pow(25.0, 7.0);
  const double stretch = 1.5 - 0.5 * std::sqrt(meanChroma7 / (meanChroma7 + twentyFive7));
  const double a1 = stretch * lab1[1];
  const double a2 = stretch * lab2[1];
  const double c1 = std::hypot(a1, lab1[2]);
  const double c2 = std::hypot(a2, lab2[2]);
  const double h1 = hueDegrees(a1, lab1[2]);
  const double h2 = hueDegrees(a2, lab2[2]);
  const bool grey = c1 * c2 == 0.0;

  double hueDifference = h2 - h1;
  double meanHue = 0.5 * (h1 + h2);
  if (grey) {
    hueDifference = 0.0;
    meanHue = h1 + h2;
  } else if (std::abs(h2 - h1) > 180.0) {
    hueDifference += h2 > h1 ? -360.0 : 360.0;
    meanHue += h1 + h2 < 360.0 ? 180.0 : -180.0;
  }
  const double dL = lab2[0] - lab1[0];
  const double dC = c2 - c1;
  const double dH = 2.0 * std::sqrt(c1 * c2) * std::sin(0.5 * hueDifference * kDegree);

  const double meanL = 0.5 * (lab1[0] + lab2[0]);
  const double meanC = 0.5 * (c1 + c2);
  const double t = 1.0 - 0.17 * std::cos((meanHue - 30.0) * kDegree) +
                   0.24 * std::cos(2.0 * meanHue * kDegree) +
                   0.32 * std::cos((3.0 * meanHue + 6.0) * kDegree) -
                   0.20 * std::cos((4.0 * meanHue - 63.0) * kDegree);
  const double fromMiddle = (meanL - 50.0) * (meanL - 50.0);
  const double sL = 1.0 + 0.015 * fromMiddle / std::sqrt(20.0 + fromMiddle);
  const double sC = 1.0 + 0.045 * meanC;
  const double sH = 1.0 + 0.015 * meanC * t;
  const double turn = (meanHue - 275.0) / 25.0;
  const double rotation = 30.0 * std::exp(-turn * turn);
  const double meanC7 = std::pow(meanC, 7.0);
  const double rT =
      -2.0 * std::sqrt(meanC7 / (meanC7 + twentyFive7)) * std::sin(2.0 * rotation * kDegree);
  return std::sqrt((dL / sL) * (dL / sL) + (dC / sC) * (dC / sC) + (dH / sH) * (dH / sH) +
                   rT * (dC / sC) * (dH / sH));
}

double individualTypologyAngle(const Eigen::Vector3d& lab) {
  return std::atan2(lab[0] - 50.0, lab[2]) / kDegree;
}

Eigen::Matrix3d adaptationMatrix(ChromaticAdaptation transform, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to) {
  if (transform == ChromaticAdaptation::none) return Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d cone = coneMatrix(transform);
  const Eigen::Vector3d gain = ((cone * to).array() / (cone * from).array()).matrix();
  return cone.inverse() * gain.asDiagonal() * cone;
}

double encodeSrgb(double linear) {
  const double x = std::abs(linear);
  const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return std::copysign(y, linear);
}

double decodeSrgb(double encoded) {
  const double y = std::abs(encoded);
  const double x = y <= 0.04045 ? y / 12.92 : std::pow((y + 0.055) / 1.055, 2.4);
  return std::copysign(x, encoded);
}

}  // namespace cutis
