#pragma once

// From linear Rec.709 to the eight bits of an sRGB screen, with an exposure and a gamma of the
// view. They act on linear values, before the curve of the screen, and change nothing that is
// exported. Immutable, so thread-safe.

#include <array>
#include <cstddef>
#include <cstdint>

namespace cutis {

struct ViewAdjustment {
  static constexpr double kMostStops = 12.0;
  static constexpr double kLeastGamma = 0.2;
  static constexpr double kMostGamma = 5.0;

  double stops = 0.0;  // of exposure, from −kMostStops to kMostStops
  double gamma = 1.0;  // above 1 the dark parts are lifted

  bool isNeutral() const { return stops == 0.0 && gamma == 1.0; }
  bool operator==(const ViewAdjustment&) const = default;
};

class DisplayCurve {
 public:
  // About a millisecond.
  explicit DisplayCurve(const ViewAdjustment& adjustment = {});
  static const DisplayCurve& neutral();

  // Clamped; not a number is 0.
  std::uint8_t operator()(float linear) const {
    const float exposed = linear * gain_;
    if (!(exposed > 0.0f)) return samples_.front();
    if (exposed >= 1.0f) return samples_.back();
    return samples_[static_cast<std::size_t>(exposed * (kSamples - 1) + 0.5f)];
  }

 private:
  // Fine enough that a step of the table is a fifth of a step of 8 bits where the curve is
  // steepest.
  static constexpr int kSamples = 16384;

  float gain_;
  std::array<std::uint8_t, kSamples> samples_ = {};
};

}  // namespace cutis
