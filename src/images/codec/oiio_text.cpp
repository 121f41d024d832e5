#include "src/images/codec/oiio_text.h"

#include <mutex>

#include <OpenImageIO/imageio.h>

namespace cutis {
namespace {

constexpr std::size_t kLongestReason = 120;

void removeAll(std::string& text, const std::string& part) {
  if (part.empty()) return;
  for (std::size_t at; (at = text.find(part)) != std::string::npos;)
    text.erase(at, part.size());
}

}  // namespace

std::string oiioReason(const std::string& message, const std::string& place) {
  std::string reason = message.substr(0, message.find_first_of("\r\n"));
  removeAll(reason, " (\"" + place + "\")");
  removeAll(reason, " image file \"" + place + "\"");
  removeAll(reason, "\"" + place + "\"");
  removeAll(reason, place);
  while (!reason.empty() && (reason.back() == '.' || reason.back() == ' '))
    reason.pop_back();
  if (reason.size() > kLongestReason) reason.resize(kLongestReason);
  return reason.empty() ? "no reason given" : reason;
}

OIIO::TypeDesc oiioType(SampleType type) {
  switch (type) {
    case SampleType::uint8:
      return OIIO::TypeUInt8;
    case SampleType::uint16:
      return OIIO::TypeUInt16;
    case SampleType::uint32:
      return OIIO::TypeUInt32;
    case SampleType::half:
      return OIIO::TypeHalf;
    case SampleType::float32:
      return OIIO::TypeFloat;
    case SampleType::float64:
      return OIIO::TypeDesc::DOUBLE;
  }
  return OIIO::TypeUnknown;
}

void setUpOpenImageIO() {
  static std::once_flag once;
  std::call_once(once, [] {
    OIIO::attribute("limits:imagesize_MB", 24 << 10);
    OIIO::attribute("limits:channels", 512);
    // Packaged builds of the library print remarks for its developers.
    OIIO::attribute("debug", 0);
  });
}

}  // namespace cutis
