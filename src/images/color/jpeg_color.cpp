#include "src/images/color/jpeg_color.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace cutis {
namespace {

constexpr std::string_view kMarker = "\xff\xe2";
constexpr std::string_view kName("ICC_PROFILE\0", 12);
constexpr std::size_t kMostBytes = 65519;
constexpr std::size_t kMostSegments = 255;

char byteOf(std::size_t value) {
  return static_cast<char>(static_cast<unsigned char>(value));
}

}  // namespace

std::string profileSegments(const std::string& profile) {
  const std::size_t count = (profile.size() + kMostBytes - 1) / kMostBytes;
  if (count > kMostSegments) return {};
  std::string segments;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view part = std::string_view(profile).substr(i * kMostBytes, kMostBytes);
    const std::size_t length = 2 + kName.size() + 2 + part.size();
    segments += kMarker;
    segments += {byteOf(length >> 8), byteOf(length & 0xff)};
    segments += kName;
    segments += {byteOf(i + 1), byteOf(count)};
    segments += part;
  }
  return segments;
}

}  // namespace cutis
