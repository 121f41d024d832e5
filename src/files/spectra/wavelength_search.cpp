#include "src/files/spectra/wavelength_search.h"

#include <algorithm>

namespace cutis {
namespace {

// Numbers side by side that make a row of wavelengths below other text.
constexpr std::size_t kFewestInRow = 3;
constexpr double kEnough = 0.5;

WavelengthPlace inRowAt(std::size_t headerRow) {
  return {false, headerRow, 0, {}};
}
WavelengthPlace inColumnAt(std::size_t column, const WavelengthRun& run) {
  return {true, 0, column, run};
}

class WavelengthSearch {
 public:
  WavelengthSearch(const FilledTable& table, Orientation preferred)
      : table_(table), preferred_(preferred) {}

  std::optional<WavelengthPlace> find() const {
    const CsvRow& first = table_.row(0);
    const WavelengthRun run = longestRun(table_.left);
    const double inRow = shareInRow(first), inColumn = shareInColumn(1, table_.left);
    if (std::max(inRow, inColumn) >= kEnough && widthOf(first) >= table_.left + 2) {
      const bool tied = inRow == inColumn;
      const bool columnsWin = tied ? preferred_ == Orientation::columns ||
                                         isWavelengthHeading(first.fields[table_.left])
                                   : inColumn > inRow;
      if (!columnsWin) return inRowAt(0);
      if (run.first <= 1 && run.count > 0 && !isNumbering(first))
        return inColumnAt(table_.left, run);
    }
    return belowText(run);
  }

 private:
  double shareInRow(const CsvRow& header) const {
    const std::size_t width = widthOf(header);
    if (width < table_.left + 2) return 0.0;
    std::size_t count = 0;
    for (std::size_t c = table_.left + 1; c < width; ++c)
      count += table_.looks(header, c) ? 1 : 0;
    return static_cast<double>(count) / static_cast<double>(width - table_.left - 1);
  }

  double shareInColumn(std::size_t from, std::size_t column) const {
    if (from >= table_.rows.size()) return 0.0;
    std::size_t count = 0;
    for (std::size_t r = from; r < table_.rows.size(); ++r)
      count += table_.looks(table_.row(r), column) ? 1 : 0;
    return static_cast<double>(count) / static_cast<double>(table_.rows.size() - from);
  }

  // Longest run of rows whose field of this column is a wavelength, with something beside it.
  WavelengthRun longestRun(std::size_t column) const {
    WavelengthRun longest, current;
    for (std::size_t r = 0; r < table_.rows.size(); ++r) {
      if (!table_.looks(table_.row(r), column) || widthOf(table_.row(r)) < column + 2) {
        current.count = 0;
        continue;
      }
      if (current.count++ == 0) current.first = r;
      if (current.count > longest.count) longest = current;
    }
    return longest;
  }

  bool headedAbove(std::size_t end, std::size_t column) const {
    for (std::size_t r = 0; r < end; ++r) {
      if (isWavelengthHeading(fieldOf(table_.row(r), column)) &&
          widthOf(table_.row(r)) > column + 1)
        return true;
    }
    return false;
  }

  // A row below other text whose wavelengths stand side by side, above rows as wide.
  bool isRowOfWavelengths(std::size_t r) const {
    std::size_t run = 0, longest = 0, count = 0;
    for (std::size_t c = table_.left; c < table_.row(r).fields.size(); ++c) {
      run = table_.looks(table_.row(r), c) ? run + 1 : 0;
      count += run > 0 ? 1 : 0;
      longest = std::max(longest, run);
    }
    const bool enough =
        longest >= kFewestInRow || (count >= 2 && shareInRow(table_.row(r)) >= kEnough);
    return enough && r + 1 < table_.rows.size() &&
           2 * widthOf(table_.row(r + 1)) > widthOf(table_.row(r));
  }

  // Whether a column further right is headed as wavelengths, so that the first only numbers rows.
  bool isNumbering(const CsvRow& header) const {
    if (isWavelengthHeading(fieldOf(header, table_.left))) return false;
    for (std::size_t c = table_.left + 1; c < table_.left + kMostLeadingColumns; ++c) {
      if (isWavelengthHeading(fieldOf(header, c)) && table_.looks(table_.row(1), c)) return true;
    }
    return false;
  }

  std::optional<WavelengthPlace> belowText(const WavelengthRun& firstColumn) const {
    std::size_t column = table_.left;
    WavelengthRun run = firstColumn;
    for (std::size_t c = table_.left + 1; c < table_.left + kMostLeadingColumns; ++c) {
      const WavelengthRun other = longestRun(c);
      const bool headed = headedAbove(other.first, c) && !headedAbove(run.first, column);
      if (other.count >= 2 && (run.count < 2 || headed)) {
        column = c;
        run = other;
      }
    }
    std::optional<std::size_t> header;
    for (std::size_t r = 0; !header && r < std::min(table_.rows.size(), kMostHeaderRows); ++r) {
      if (isRowOfWavelengths(r)) header = r;
    }
    const bool inColumn = run.count >= 2 || (run.count == 1 && headedAbove(run.first, column));
    if (!inColumn && !header) return std::nullopt;
    if (!inColumn) return inRowAt(*header);
    if (!header || *header > run.first) return inColumnAt(column, run);
    // Wavelengths above numbered rows, or counts beside wavelengths.
    const double rowShare = shareInRow(table_.row(*header));
    const double columnShare = shareInColumn(*header + 1, column);
    const bool headed = headedAbove(run.first, column);
    if (headed || columnShare > rowShare ||
        (columnShare == rowShare && preferred_ == Orientation::columns)) {
      return inColumnAt(column, run);
    }
    return inRowAt(*header);
  }

  const FilledTable& table_;
  const Orientation preferred_;
};

}  // namespace

std::size_t widthOf(const CsvRow& row) {
  std::size_t width = row.fields.size();
  while (width > 0 && row.fields[width - 1].empty())
    --width;
  return width;
}

std::string_view fieldOf(const CsvRow& row, std::size_t column) {
  return column < row.fields.size() ? row.fields[column] : std::string_view();
}

FilledTable::FilledTable(const CsvTable& table) {
  rows.reserve(table.size());
  left = std::string_view::npos;
  for (const CsvRow& row : table) {
    if (widthOf(row) == 0) continue;
    rows.push_back(&row);
    std::size_t first = 0;
    while (row.fields[first].empty())
      ++first;
    left = std::min(left, first);
  }
}

std::optional<WavelengthPlace> findWavelengths(const FilledTable& table, Orientation preferred) {
  return WavelengthSearch(table, preferred).find();
}

}  // namespace cutis
