#pragma once

// Rows of comma-separated text. `#` starts a comment line; empty lines are passed over; fields are
// trimmed of blanks, carriage returns and one pair of double quotes.

#include <string_view>
#include <vector>

namespace cutis {

struct CsvRow {
  int line = 0;  // in the file, from 1
  std::vector<std::string_view> fields;
};

// Views into text.
std::vector<CsvRow> splitCsv(std::string_view text);

}  // namespace cutis
