#pragma once

// Columns of text that line up, for people.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace cutis {

// The first columns are set flush left, the others flush right. Widths count characters of UTF-8,
// not bytes.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> header, std::size_t leftColumns = 1)
      : rows_{std::move(header)}, leftColumns_(leftColumns) {}

  // A row of as many cells as the header has.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
  std::size_t leftColumns_;
};

}  // namespace cutis
