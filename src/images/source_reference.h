#pragma once

// Where a result comes from: maps and captures name the files they were made from.

#include <string>

namespace cutis {

// A file that a result was made from: enough to find it again and to tell whether it changed.
struct SourceReference {
  std::string file;  // relative to the result where that is possible
  std::string hash;  // ContentHash of its bytes
  bool operator==(const SourceReference&) const = default;
};

}  // namespace cutis
