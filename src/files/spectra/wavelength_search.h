#pragma once  // internal to src/files/spectra

// Which row or column of a table has the wavelengths.

#include <optional>
#include <vector>

#include "src/files/io/csv.h"
#include "src/files/spectra/wavelength_text.h"

namespace cutis {

// What one spectrum a row or one a column is taken for where both would do and no heading decides.
enum class Orientation { rows, columns };

// The fields of a row up to its last that is not empty.
std::size_t widthOf(const CsvRow& row);
// Empty beyond the end of the row.
std::string_view fieldOf(const CsvRow& row, std::size_t column);

// Headings are looked for so far down, and wavelengths so far to the right.
inline constexpr std::size_t kMostHeaderRows = 1000;
inline constexpr std::size_t kMostLeadingColumns = 3;

// A table without empty rows, and how its wavelengths are written. Refers to the table.
struct FilledTable {
  std::vector<const CsvRow*> rows;
  std::size_t left = 0;  // first column that something stands in
  WavelengthFormat format;

  explicit FilledTable(const CsvTable& table);

  const CsvRow& row(std::size_t r) const { return *rows[r]; }
  bool looks(const CsvRow& row, std::size_t column) const {
    return looksLikeWavelength(fieldOf(row, column), format);
  }
  bool isNumber(std::string_view field) const { return format.numbers.parse(field).has_value(); }
};

// Rows that have a wavelength in the same column, one below the other.
struct WavelengthRun {
  std::size_t first = 0, count = 0;
};

struct WavelengthPlace {
  bool inColumn = false;
  std::size_t headerRow = 0;  // with the wavelengths, if they stand in a row
  std::size_t column = 0;     // with the wavelengths, if they stand in a column
  WavelengthRun run;          // the longest of that column
};

// Nothing if there are no wavelengths. Precondition: the table has rows.
std::optional<WavelengthPlace> findWavelengths(const FilledTable& table, Orientation preferred);

}  // namespace cutis
