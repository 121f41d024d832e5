#include "src/images/codec/oiio_text.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
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

bool saysOneOf(const std::string& message, std::initializer_list<const char*> parts) {
  std::string lower = message;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(parts.begin(), parts.end(),
                     [&](const char* part) { return lower.find(part) != std::string::npos; });
}

}  // namespace

Error readingError(const std::string& message, const std::string& format,
                   const std::string& place) {
  const std::string reason = oiioReason(message, place);
  if (saysOneOf(message,
                {"out of memory", "not enough memory", "insufficient memory", "bad_alloc",
                 "cannot allocate", "could not allocate", "failed to allocate", "no space for"})) {
    return resourceError(place, "not enough memory for the image; use a smaller one");
  }
  if (saysOneOf(message, {"support", "not implemented", "not configured", "unknown compression",
                          "cannot handle", "can't handle", "don't know how"})) {
    return inputError(place, "this kind of " + format + " file is not supported (" + reason +
                                 "); save it in a more usual way");
  }
  return inputError(
      place, "the " + format + " file is damaged or cut off (" + reason + "); get a sound copy");
}

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
