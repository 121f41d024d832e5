#include "src/files/io/text_file.h"

#include <vector>

#include "src/files/io/input_file.h"
#include "src/files/io/presence.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;

}  // namespace

Result<std::string> readTextFile(const fs::path& path, std::size_t limitBytes) {
  const std::string place = path.string();
  CUTIS_TRY(status, presentStatus(path));
  if (fs::is_directory(status)) return inputError(place, "this is a folder; name a file in it");
  CUTIS_TRY(file, InputFile::open(path));
  std::string text;
  std::vector<char> buffer(kBufferBytes);
  for (;;) {
    CUTIS_TRY(count, file.read(buffer));
    if (count == 0) break;
    text.append(buffer.data(), count);
    if (text.size() > limitBytes) {
      return inputError(place, "the file is larger than " + std::to_string(limitBytes >> 20) +
                                   " MiB; this does not look like the right file");
    }
  }
  if (text.empty()) return inputError(place, "the file is empty; use one with content");
  return text;
}

}  // namespace cutis
