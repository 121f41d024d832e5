#include "src/files/resources.h"

#include <algorithm>

#include "resources/resource_data.h"

namespace cutis {

std::optional<std::string_view> resource(std::string_view name) {
  for (unsigned i = 0; i < kResourceCount; ++i) {
    const ResourceData& data = kResourceData[i];
    if (name == data.name) {
      return std::string_view(reinterpret_cast<const char*>(data.bytes), data.size);
    }
  }
  return std::nullopt;
}

std::vector<std::string> resourceStems(std::string_view folder, std::string_view suffix) {
  std::vector<std::string> stems;
  for (unsigned i = 0; i < kResourceCount; ++i) {
    std::string_view name = kResourceData[i].name;
    if (!name.starts_with(folder) || !name.ends_with(suffix)) continue;
    name.remove_prefix(folder.size());
    if (!name.starts_with('/')) continue;
    name.remove_prefix(1);
    name.remove_suffix(suffix.size());
    if (name.find('/') == std::string_view::npos) stems.emplace_back(name);
  }
  std::sort(stems.begin(), stems.end());
  return stems;
}

}  // namespace cutis
