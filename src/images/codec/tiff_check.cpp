#include "src/images/codec/tiff_check.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <optional>
#include <vector>

namespace cutis {
namespace {

constexpr int kStripOffsets = 273;
constexpr int kStripByteCounts = 279;
constexpr int kTileOffsets = 324;
constexpr int kTileByteCounts = 325;

// A list of whole numbers in the directory: where it lies, and in which form.
struct Field {
  std::uint64_t position = 0;
  std::uint64_t count = 0;
  int bytesEach = 0;
};

// Knows only what a list of offsets may be made of: SHORT, LONG and LONG8.
int bytesOfType(std::uint64_t type) {
  switch (type) {
    case 3:
      return 2;
    case 4:
      return 4;
    case 16:
      return 8;
    default:
      return 0;
  }
}

class TiffFile {
 public:
  explicit TiffFile(const std::filesystem::path& path) : stream_(path, std::ios::binary) {
    stream_.seekg(0, std::ios::end);
    length_ = static_cast<std::uint64_t>(std::max<std::streamoff>(0, stream_.tellg()));
    stream_.seekg(0);
    littleEndian_ = stream_.get() == 'I';
    isBig_ = number(2, 2).value_or(0) == 43;
  }

  std::uint64_t length() const { return length_; }

  // Returns nothing beyond the end of the file.
  std::optional<std::uint64_t> number(std::uint64_t position, int bytes) {
    const auto list = values({position, 1, bytes});
    return list ? std::optional(list->front()) : std::nullopt;
  }

  // All of a list; nothing if it reaches beyond the end of the file.
  std::optional<std::vector<std::uint64_t>> values(const Field& field) {
    const auto each = static_cast<std::size_t>(field.bytesEach);
    if (field.position > length_ || field.count > (length_ - field.position) / each) return {};
    std::vector<unsigned char> bytes(static_cast<std::size_t>(field.count) * each);
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(field.position));
    stream_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream_) return {};
    std::vector<std::uint64_t> values(static_cast<std::size_t>(field.count));
    for (std::size_t k = 0; k < bytes.size(); ++k) {
      const std::size_t inside = k % each;
      const std::size_t digit = littleEndian_ ? each - 1 - inside : inside;
      values[k / each] = values[k / each] << 8 | bytes[k - inside + digit];
    }
    return values;
  }

  // The field of a tag in the first directory; nothing if it is not there or is no list of numbers.
  std::optional<Field> find(int tag) {
    const int word = isBig_ ? 8 : 4;  // of counts and offsets
    const int countBytes = isBig_ ? 8 : 2;
    const std::uint64_t entryBytes = isBig_ ? 20 : 12;
    const auto directory = number(isBig_ ? 8 : 4, word);
    const auto entries = directory ? number(*directory, countBytes) : std::nullopt;
    if (!entries) return {};
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(*entries, 65535); ++i) {
      const std::uint64_t entry =
          *directory + static_cast<std::uint64_t>(countBytes) + i * entryBytes;
      const auto name = number(entry, 2);
      if (!name) return {};
      if (*name != static_cast<std::uint64_t>(tag)) continue;
      const auto type = number(entry + 2, 2);
      const auto count = number(entry + 4, word);
      const std::uint64_t valueAt = entry + 4 + static_cast<std::uint64_t>(word);
      const auto value = number(valueAt, word);
      if (!type || !count || !value || bytesOfType(*type) == 0) return {};
      Field field = {valueAt, *count, bytesOfType(*type)};
      // Few values lie in the entry itself.
      const auto fitting = static_cast<std::uint64_t>(word / field.bytesEach);
      if (*count > fitting) field.position = *value;
      return field;
    }
    return {};
  }

 private:
  std::ifstream stream_;
  std::uint64_t length_ = 0;
  bool littleEndian_ = true;
  bool isBig_ = false;
};

}  // namespace

Status checkTiffExtent(const std::filesystem::path& path) {
  const auto cutOff = [&] {
    return inputError(path.string(), "the TIFF file is cut off; get a complete copy");
  };
  TiffFile file(path);
  for (const auto& [offsetTag, countTag] :
       {std::pair{kStripOffsets, kStripByteCounts}, std::pair{kTileOffsets, kTileByteCounts}}) {
    const auto offsetField = file.find(offsetTag), countField = file.find(countTag);
    // Very old files have no byte counts; libtiff then works them out.
    if (!offsetField || !countField) continue;
    const auto offsets = file.values(*offsetField), counts = file.values(*countField);
    if (!offsets || !counts) return cutOff();
    for (std::size_t i = 0; i < std::min(offsets->size(), counts->size()); ++i) {
      if ((*offsets)[i] > file.length() || (*counts)[i] > file.length() - (*offsets)[i]) {
        return cutOff();
      }
    }
  }
  return {};
}

}  // namespace cutis
