#include "src/images/codec/layout_check.h"

#include "src/images/codec/image_reader.h"

namespace cutis {
namespace {

constexpr int kFarthestOrigin = 1 << 24;

bool isFarOut(const OIIO::ImageSpec& spec) {
  const auto far = [](int v) { return v < -kFarthestOrigin || v > kFarthestOrigin; };
  return far(spec.x) || far(spec.y) || far(spec.full_x) || far(spec.full_y);
}

}  // namespace

bool exceedsLimits(std::int64_t width, std::int64_t height) {
  return width > kLargestSide || height > kLargestSide || width * height > kMostPixels;
}

Status checkLayout(const OIIO::ImageSpec& spec, const std::string& place) {
  if (spec.deep) {
    return inputError(place,
                      "deep pixels (many samples in one) are not supported; flatten the image");
  }
  if (spec.depth > 1) {
    return inputError(place, "volumes are not supported; save one slice as an image");
  }
  if (spec.nchannels <= 0 || spec.width <= 0 || spec.height <= 0) {
    return inputError(place, "the image has no pixels or no channels; save it again");
  }
  if (spec.nchannels > kMostChannels) {
    return inputError(place, "the image has " + std::to_string(spec.nchannels) +
                                 " channels; at most " + std::to_string(kMostChannels) +
                                 " are read");
  }
  if (exceedsLimits(spec.width, spec.height) || exceedsLimits(spec.full_width, spec.full_height)) {
    return inputError(place, "the image is " + std::to_string(spec.width) + " × " +
                                 std::to_string(spec.height) + " pixels; at most " +
                                 std::to_string(kLargestSide) + " a side and " +
                                 std::to_string(kMostPixels) + " in all are read; make it smaller");
  }
  if (isFarOut(spec)) {
    return inputError(place,
                      "the data window of the image lies implausibly far out; save it again");
  }
  return {};
}

}  // namespace cutis
