#include "src/images/color/heif_color.h"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <vector>

#include "src/color/icc_profile.h"

namespace cutis {
namespace {

constexpr std::size_t kMostBoxBytes = 4 * kLargestProfileBytes;

struct Box {
  std::string_view name;
  std::string_view content;
};

// Numbers from the front of some bytes, with the most significant first.
class BoxBytes {
 public:
  explicit BoxBytes(std::string_view bytes) : bytes_(bytes) {}

  bool failed() const { return failed_; }
  std::string_view rest() const { return bytes_; }

  std::uint64_t number(std::size_t bytes) {
    std::uint64_t value = 0;
    for (const char byte : text(bytes))
      value = value << 8 | static_cast<unsigned char>(byte);
    return value;
  }
  std::string_view text(std::size_t bytes) {
    failed_ = failed_ || bytes > bytes_.size();
    const std::string_view text = bytes_.substr(0, bytes);
    bytes_.remove_prefix(text.size());
    return text;
  }

 private:
  std::string_view bytes_;
  bool failed_ = false;
};

// One after the other, up to the first that is damaged.
std::vector<Box> boxesIn(std::string_view bytes) {
  std::vector<Box> boxes;
  while (bytes.size() >= 8) {
    BoxBytes head(bytes);
    std::uint64_t length = head.number(4);
    const std::string_view name = head.text(4);
    if (length == 1) length = head.number(8);
    if (length == 0) length = bytes.size();
    const std::size_t headBytes = bytes.size() - head.rest().size();
    if (head.failed() || length < headBytes || length > bytes.size()) break;
    const auto size = static_cast<std::size_t>(length);
    boxes.push_back({name, bytes.substr(headBytes, size - headBytes)});
    bytes.remove_prefix(size);
  }
  return boxes;
}

std::string_view contentOf(const std::vector<Box>& boxes, std::string_view name) {
  for (const Box& box : boxes) {
    if (box.name == name) return box.content;
  }
  return {};
}

// The content of the box meta at the top of the file, without its version and flags.
std::string metaOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string head(16, '\0');
  while (stream.read(head.data(), 8)) {
    BoxBytes numbers(head);
    std::uint64_t length = numbers.number(4), headBytes = 8;
    const std::string name(numbers.text(4));
    if (length == 1 && stream.read(head.data() + 8, 8)) {
      length = numbers.number(8);
      headBytes = 16;
    }
    if (length < headBytes || length > std::uint64_t{1} << 40) return {};
    const std::uint64_t size = length - headBytes;
    if (name != "meta") {
      stream.seekg(static_cast<std::streamoff>(size), std::ios::cur);
      continue;
    }
    if (size < 4 || size > kMostBoxBytes) return {};
    std::string content(static_cast<std::size_t>(size), '\0');
    if (!stream.read(content.data(), static_cast<std::streamsize>(size))) return {};
    return content.substr(4);
  }
  return {};
}

// The number of the picture that is meant when none is named.
std::uint64_t primaryItem(std::string_view pitm) {
  BoxBytes bytes(pitm);
  const std::uint64_t version = bytes.number(1);
  bytes.number(3);
  return bytes.number(version == 0 ? 2 : 4);
}

// The places of a picture's properties in their list, from 1.
std::vector<std::size_t> propertiesOf(std::uint64_t item, std::string_view ipma) {
  BoxBytes bytes(ipma);
  const std::uint64_t version = bytes.number(1), flags = bytes.number(3);
  const std::size_t indexBytes = (flags & 1) != 0 ? 2 : 1;
  const std::uint64_t indexMask = indexBytes == 2 ? 0x7fff : 0x7f;
  const std::uint64_t items = bytes.number(4);
  for (std::uint64_t i = 0; i < items && !bytes.failed(); ++i) {
    const std::uint64_t id = bytes.number(version < 1 ? 2 : 4);
    std::vector<std::size_t> properties;
    for (std::uint64_t left = bytes.number(1); left > 0 && !bytes.failed(); --left)
      properties.push_back(static_cast<std::size_t>(bytes.number(indexBytes) & indexMask));
    if (id == item) return properties;
  }
  return {};
}

void takeColr(std::string_view content, HeifColors& colors) {
  BoxBytes bytes(content);
  const std::string_view type = bytes.text(4);
  if (type == "prof" || type == "rICC") {
    if (bytes.rest().size() <= kLargestProfileBytes) colors.profile = std::string(bytes.rest());
  } else if (type == "nclx") {
    CodePoints points;
    points.primaries = static_cast<int>(bytes.number(2));
    points.transfer = static_cast<int>(bytes.number(2));
    if (!bytes.failed()) colors.codePoints = points;
  }
}

}  // namespace

HeifColors readHeifColors(const std::filesystem::path& path) {
  HeifColors colors;
  const std::string meta = metaOf(path);
  const std::vector<Box> boxes = boxesIn(meta);
  const std::vector<Box> properties = boxesIn(contentOf(boxes, "iprp"));
  const std::vector<Box> list = boxesIn(contentOf(properties, "ipco"));
  const std::uint64_t primary = primaryItem(contentOf(boxes, "pitm"));
  for (const std::size_t place : propertiesOf(primary, contentOf(properties, "ipma"))) {
    if (place > 0 && place <= list.size() && list[place - 1].name == "colr")
      takeColr(list[place - 1].content, colors);
  }
  return colors;
}

}  // namespace cutis
