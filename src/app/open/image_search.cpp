#include "src/app/open/image_search.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include "src/files/io/file_extension.h"
#include "src/images/codec/image_formats.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMask = "mask";

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool isImageName(const fs::path& file) {
  const std::string extension = lowerExtension(file);
  return std::any_of(imageFormats().begin(), imageFormats().end(), [&](const ImageFormat& format) {
    return std::find(format.extensions.begin(), format.extensions.end(), extension) !=
           format.extensions.end();
  });
}

std::vector<fs::path> imagesIn(const fs::path& folder) {
  std::vector<fs::path> images;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file(error) && isImageName(entry.path())) images.push_back(entry.path());
  }
  std::sort(images.begin(), images.end());
  return images;
}

// Whether no letter and, before it, no digit touches the word; "faceMask" is two words.
bool standsAlone(const std::string& stem, std::size_t at) {
  const auto character = [&](std::size_t k) { return static_cast<unsigned char>(stem[k]); };
  const bool begins = at == 0 || std::isalnum(character(at - 1)) == 0 ||
                      (std::isupper(character(at)) != 0 && std::islower(character(at - 1)) != 0);
  const std::size_t end = at + kMask.size();
  return begins && (end == stem.size() || std::isalpha(character(end)) == 0);
}

}  // namespace

std::vector<fs::path> photographsIn(const fs::path& folder) {
  std::vector<fs::path> images = imagesIn(folder);
  std::erase_if(images, isNamedMask);
  return images;
}

bool isNamedMask(const fs::path& file) {
  const std::string stem = file.stem().string();
  if (stem.size() < kMask.size()) return false;
  const std::size_t at = stem.size() - kMask.size();
  const bool standsApart = at == 0 || std::isalnum(static_cast<unsigned char>(stem[at - 1])) == 0;
  return standsApart && lowerCase(stem.substr(at)) == kMask;
}

fs::path maskBeside(const fs::path& photograph) {
  const std::string stem = photograph.stem().string();
  fs::path ofAll;
  for (const fs::path& file : imagesIn(photograph.parent_path())) {
    const std::string name = file.stem().string();
    if (file == photograph || !isNamedMask(file)) continue;
    if (name.size() == kMask.size()) ofAll = file;
    if (name.size() == stem.size() + 1 + kMask.size() && name.starts_with(stem)) {
      return file;
    }
  }
  return ofAll;
}

bool mayBeMask(const fs::path& file) {
  if (!isImageName(file)) return false;
  const std::string stem = file.stem().string();
  const std::string lower = lowerCase(stem);
  for (std::size_t at = lower.find(kMask); at != std::string::npos;
       at = lower.find(kMask, at + 1)) {
    if (standsAlone(stem, at)) return true;
  }
  return false;
}

}  // namespace cutis
