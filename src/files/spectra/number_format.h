#pragma once  // internal to src/files/spectra

// How a table writes numbers and divides them: found out from all of it, never field by field.

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "src/files/io/csv.h"

namespace cutis {

// The separator under which most fields of the first rows are numbers; a comma where several are.
char separatorOf(std::string_view text);

class NumberFormat {
 public:
  NumberFormat() = default;
  // Commas are decimal marks where more fields read so than with points.
  NumberFormat(std::string_view text, const CsvTable& table, char separator);

  bool hasDecimalCommas() const { return decimalComma_; }

  // Nothing for text that is not wholly a number. Blanks around it do not matter; NaN and infinity
  // are numbers. Thousands may be grouped where a decimal mark shows which mark groups them.
  std::optional<double> parse(std::string_view field) const;
  // Why parse() gave nothing: "'1.234' may be …; what to do".
  std::string objection(std::string_view field) const;

 private:
  bool decimalComma_ = false;
};

// The field in quotes, on one line and cut to 80 characters.
std::string echoed(std::string_view field);

}  // namespace cutis
