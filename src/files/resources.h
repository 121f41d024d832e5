#pragma once

// Files that travel inside the program, by their path below resources/.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cutis {

// Valid for the life of the program.
std::optional<std::string_view> resource(std::string_view name);

// Names of the resources directly in `folder`, without the folder and without `suffix`, sorted.
std::vector<std::string> resourceStems(std::string_view folder, std::string_view suffix);

}  // namespace cutis
