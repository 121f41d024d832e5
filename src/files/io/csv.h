#pragma once

// Rows of comma-separated text. `#` starts a comment line; empty lines are passed over; fields are
// trimmed of blanks, carriage returns and one pair of double quotes.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace cutis {

struct CsvRow {
  int line = 0;  // in the file, from 1
  std::vector<std::string_view> fields;
};

// Views into text.
std::vector<CsvRow> splitCsv(std::string_view text);

// Locale-independent; nothing for text that is not wholly a number.
std::optional<double> parseNumber(std::string_view text);

// `digits` significant digits, without trailing zeros; independent of the locale.
std::string formatNumber(double value, int digits = 9);

}  // namespace cutis
