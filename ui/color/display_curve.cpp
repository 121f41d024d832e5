#include "ui/color/display_curve.h"

#include <cmath>

#include "core/spectra/colorimetry.h"

namespace cutis {

DisplayCurve::DisplayCurve(const ViewAdjustment& adjustment)
    : gain_(static_cast<float>(std::exp2(adjustment.stops))) {
  for (int i = 0; i < kSamples; ++i) {
    const double linear = static_cast<double>(i) / (kSamples - 1);
    const double encoded = encodeSrgb(std::pow(linear, 1.0 / adjustment.gamma));
    samples_[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(255.0 * encoded));
  }
}

const DisplayCurve& DisplayCurve::neutral() {
  static const DisplayCurve curve;
  return curve;
}

}  // namespace cutis
