#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace cutis::test {

namespace fs = std::filesystem;

fs::path ScratchFolder::write(const std::string& name, std::string_view bytes) const {
  const fs::path file = path() / name;
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

std::string ScratchFolder::read(const std::string& name) const {
  std::ifstream stream(path() / name, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<std::string> ScratchFolder::names() const {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(path())) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace cutis::test
