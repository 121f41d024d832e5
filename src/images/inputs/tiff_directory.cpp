#include "src/images/inputs/tiff_directory.h"

#include <algorithm>
#include <cstddef>

namespace cutis {
namespace {

// The numbers that a value of a type consists of.
struct TypeLayout {
  int numbers = 0;
  int bytesEach = 0;
};

TypeLayout layoutOf(std::uint64_t type) {
  switch (type) {
    case 3:  // SHORT
      return {1, 2};
    case 4:  // LONG
      return {1, 4};
    case 5:  // RATIONAL
      return {2, 4};
    case 16:  // LONG8
      return {1, 8};
    default:
      return {};
  }
}

}  // namespace

TiffDirectory::TiffDirectory(const std::filesystem::path& path) : stream_(path, std::ios::binary) {
  stream_.seekg(0, std::ios::end);
  length_ = static_cast<std::uint64_t>(std::max<std::streamoff>(0, stream_.tellg()));
  stream_.seekg(0);
  littleEndian_ = stream_.get() == 'I';
  isBig_ = number(2, 2).value_or(0) == 43;
}

std::optional<std::uint64_t> TiffDirectory::number(std::uint64_t position, int bytes) {
  const auto list = values(Field{position, 1, bytes});
  return list ? std::optional(list->front()) : std::nullopt;
}

std::optional<std::vector<std::uint64_t>> TiffDirectory::values(const Field& field) {
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

std::optional<std::vector<std::uint64_t>> TiffDirectory::values(int tag) {
  const auto field = find(tag);
  return field ? values(*field) : std::nullopt;
}

std::optional<TiffDirectory::Field> TiffDirectory::find(int tag) {
  const int countBytes = isBig_ ? 8 : 2;
  const std::uint64_t entryBytes = isBig_ ? 20 : 12;
  const auto directory = number(isBig_ ? 8 : 4, isBig_ ? 8 : 4);
  const auto entries = directory ? number(*directory, countBytes) : std::nullopt;
  if (!entries) return {};
  for (std::uint64_t i = 0; i < std::min<std::uint64_t>(*entries, 65535); ++i) {
    const std::uint64_t entry =
        *directory + static_cast<std::uint64_t>(countBytes) + i * entryBytes;
    const auto name = number(entry, 2);
    if (!name) return {};
    if (*name == static_cast<std::uint64_t>(tag)) return fieldAt(entry);
  }
  return {};
}

std::optional<TiffDirectory::Field> TiffDirectory::fieldAt(std::uint64_t entry) {
  const int word = isBig_ ? 8 : 4;  // of counts and offsets
  const auto type = number(entry + 2, 2);
  const auto count = number(entry + 4, word);
  const std::uint64_t valueAt = entry + 4 + static_cast<std::uint64_t>(word);
  const auto value = number(valueAt, word);
  if (!type || !count || !value) return {};
  const TypeLayout layout = layoutOf(*type);
  if (layout.numbers == 0) return {};
  // Beyond what the file could hold it does not matter how many there are.
  const std::uint64_t most = std::uint64_t{1} << 62;
  Field field = {valueAt, std::min(*count, most) * static_cast<std::uint64_t>(layout.numbers),
                 layout.bytesEach};
  // Few values lie in the entry itself.
  if (field.count > static_cast<std::uint64_t>(word / field.bytesEach)) field.position = *value;
  return field;
}

}  // namespace cutis
