#include "src/color/video_curve.h"

#include <algorithm>
#include <cmath>

namespace cutis {
namespace {

namespace pq {

constexpr double kM1 = 2610.0 / 16384.0, kM2 = 128.0 * 2523.0 / 4096.0;
constexpr double kC1 = 3424.0 / 4096.0, kC2 = 32.0 * 2413.0 / 4096.0, kC3 = 32.0 * 2392.0 / 4096.0;
constexpr double kPeak = 10000.0, kWhite = 203.0;  // cd/m²

double toLight(double number) {
  const double x = std::pow(std::clamp(number, 0.0, 1.0), 1.0 / kM2);
  return kPeak / kWhite * std::pow(std::max(x - kC1, 0.0) / (kC2 - kC3 * x), 1.0 / kM1);
}

double fromLight(double light) {
  if (light <= 0.0) return 0.0;
  const double y = std::pow(std::min(light * kWhite / kPeak, 1.0), kM1);
  return std::pow((kC1 + kC2 * y) / (1.0 + kC3 * y), kM2);
}

}  // namespace pq

namespace hlg {

constexpr double kA = 0.17883277, kB = 1.0 - 4.0 * kA;
constexpr double kWhite = 0.75;  // as a signal

// Light is 1 for the signal 1.
double sceneLight(double number) {
  const double c = 0.5 - kA * std::log(4.0 * kA);
  return number <= 0.5 ? number * number / 3.0 : (std::exp((number - c) / kA) + kB) / 12.0;
}

double toLight(double number) {
  return sceneLight(number) / sceneLight(kWhite);
}

double fromLight(double light) {
  const double c = 0.5 - kA * std::log(4.0 * kA);
  const double scene = light * sceneLight(kWhite);
  return scene <= 1.0 / 12.0 ? std::sqrt(3.0 * scene) : kA * std::log(12.0 * scene - kB) + c;
}

}  // namespace hlg

template <int tenthsOfDecade>
double lightOfLogarithm(double number) {
  return number <= 0.0 ? 0.0 : std::pow(10.0, tenthsOfDecade / 10.0 * (number - 1.0));
}

template <int tenthsOfDecade>
double logarithmOfLight(double light) {
  const double number = 1.0 + std::log10(std::max(light, 1e-30)) * 10.0 / tenthsOfDecade;
  return std::isnan(light) ? light : std::max(number, 0.0);
}

}  // namespace

TransferCurve pqCurve() {
  static constexpr TransferCurve::Formula formula = {"PQ", pq::toLight, pq::fromLight};
  return TransferCurve::ofFormula(formula);
}

TransferCurve hlgCurve() {
  static constexpr TransferCurve::Formula formula = {"HLG", hlg::toLight, hlg::fromLight};
  return TransferCurve::ofFormula(formula);
}

TransferCurve logarithmicCurve(bool isLonger) {
  static constexpr TransferCurve::Formula shorter = {"logarithmic over 2 decades",
                                                     lightOfLogarithm<20>, logarithmOfLight<20>};
  static constexpr TransferCurve::Formula longer = {"logarithmic over 2.5 decades",
                                                    lightOfLogarithm<25>, logarithmOfLight<25>};
  return TransferCurve::ofFormula(isLonger ? longer : shorter);
}

}  // namespace cutis
