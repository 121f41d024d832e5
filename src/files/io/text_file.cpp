#include "src/files/io/text_file.h"

#include <fstream>

namespace cutis {

namespace fs = std::filesystem;

Result<std::string> readTextFile(const fs::path& path, std::size_t limitBytes) {
  const std::string place = path.string();
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return inputError(place, "there is no such file; check the name");
  if (fs::is_directory(status)) return inputError(place, "this is a folder; name a file in it");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return inputError(place, "the file cannot be opened; check its permissions");
  std::string text;
  char buffer[1 << 16];
  while (stream.read(buffer, sizeof buffer) || stream.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > limitBytes) {
      return inputError(place, "the file is larger than " + std::to_string(limitBytes >> 20) +
                                   " MiB; this does not look like the right file");
    }
  }
  if (stream.bad()) return inputError(place, "the file cannot be read to its end; check the disk");
  if (text.empty()) return inputError(place, "the file is empty; use one with content");
  return text;
}

}  // namespace cutis
