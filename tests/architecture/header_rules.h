#pragma once

// Rules on single headers and on rooms: every header opens with a sentence, what a room keeps for
// itself is told apart from its face, and no room grows beyond what a reader can walk through.
//
// A header that is meant for its own room alone says so in its first line:
//
//   #pragma once  // internal to core/fit/free
//
// No other room may include it. All other headers are the room's face, and some other room includes
// them. Headers of vectorised code (-inl.h) are parts of a translation unit and need no mark.
// Checks return sentences, one per violation.

#include <cstddef>
#include <string>
#include <vector>

#include "tests/architecture/house_rules.h"

namespace cutis::test {

std::vector<std::string> checkOpening(const std::string& path, const std::string& text);

// The room that the mark names; empty without one.
std::string markedRoom(const std::string& text);

// Marks held against the include lines of the whole tree.
std::vector<std::string> checkInternal(const SourceTree& tree);

// Source files directly in a folder.
inline constexpr std::size_t kMaximumFiles = 32;

std::vector<std::string> checkRoomSizes(const SourceTree& tree);

}  // namespace cutis::test
