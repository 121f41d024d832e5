#include "src/files/spectra/spectral_layout.h"

#include <algorithm>
#include <optional>

#include "core/base/number_text.h"

namespace cutis {

namespace {

// Headings are looked for so far down, and wavelengths so far to the right.
constexpr std::size_t kMostHeaderRows = 1000;
constexpr std::size_t kMostLeadingColumns = 3;
// Numbers side by side that make a row of wavelengths below other text.
constexpr std::size_t kFewestInRow = 3;
constexpr double kEnough = 0.5;
// No wavelength of light that a heading in micrometres could mean.
constexpr double kImplausibleNm = 50000.0;

std::size_t widthOf(const CsvRow& row) {
  std::size_t width = row.fields.size();
  while (width > 0 && row.fields[width - 1].empty())
    --width;
  return width;
}

std::string_view fieldOf(const CsvRow& row, std::size_t column) {
  return column < row.fields.size() ? row.fields[column] : std::string_view();
}

bool beginsLikeNumber(std::string_view field) {
  return !field.empty() && field.front() >= '0' && field.front() <= '9';
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
    text += (i > 0 ? ", " : "") + echoed(names[i]);
  if (names.size() > kMost) text += " and " + std::to_string(names.size() - kMost) + " more";
  return text;
}

}  // namespace

class LayoutFinder {
 public:
  LayoutFinder(const CsvTable& table, const NumberFormat& numbers, const LayoutOptions& options,
               const std::string& place)
      : options_(options), place_(place) {
    format_.numbers = numbers;
    format_.labelled = options.labelled;
    dropEmpty(table);
    layout_.place_ = place;
  }

  Result<SpectralLayout> find() {
    if (rows_.empty()) return inputError(place_, "the file has no rows; begin with wavelengths");
    CUTIS_CHECK(takeUnit());
    if (!choose() && !options_.labelled) {
      format_.labelled = true;
      if (!choose()) return nothingFound();
    }
    layout_.inColumns_ = inColumns_;
    CUTIS_CHECK(inColumns_ ? layOutColumns() : layOutRows());
    CUTIS_CHECK(checkScale());
    return std::move(layout_);
  }

 private:
  const CsvRow& row(std::size_t r) const { return *rows_[r]; }

  std::string at(const CsvRow& row) const { return place_ + ":" + std::to_string(row.line); }
  std::string at(const CsvRow& row, std::size_t column) const {
    return at(row) + ", column " + std::to_string(column + 1);
  }

  // Rows without content, and the columns on the left that nothing stands in.
  void dropEmpty(const CsvTable& table) {
    rows_.reserve(table.size());
    left_ = std::string_view::npos;
    for (const CsvRow& row : table) {
      if (widthOf(row) == 0) continue;
      rows_.push_back(&row);
      std::size_t first = 0;
      while (row.fields[first].empty())
        ++first;
      left_ = std::min(left_, first);
    }
  }

  bool looks(const CsvRow& row, std::size_t column) const {
    return looksLikeWavelength(fieldOf(row, column), format_);
  }
  bool isNumber(std::string_view field) const { return format_.numbers.parse(field).has_value(); }

  // The lowest heading above the numbers that names a unit.
  Status takeUnit() {
    for (std::size_t r = 0; r < std::min(rows_.size(), kMostHeaderRows); ++r) {
      for (std::size_t c = left_; c < left_ + kMostLeadingColumns; ++c) {
        const std::string_view field = fieldOf(row(r), c);
        if (field.empty() || widthOf(row(r)) < 2 || !isWavelengthHeading(withoutBlanks(field)) ||
            isNumber(field)) {
          continue;
        }
        const auto unit = unitOf(field);
        if (!unit) continue;
        format_.unit = *unit;
        unitPlace_ = at(row(r), c);
      }
    }
    if (format_.unit != WavelengthUnit::wavenumbers) return {};
    return inputError(unitPlace_,
                      "the heading names wavenumbers; convert them to wavelengths in nm");
  }

  double shareInRow(const CsvRow& header) const {
    const std::size_t width = widthOf(header);
    if (width < left_ + 2) return 0.0;
    std::size_t count = 0;
    for (std::size_t c = left_ + 1; c < width; ++c)
      count += looks(header, c) ? 1 : 0;
    return static_cast<double>(count) / static_cast<double>(width - left_ - 1);
  }

  double shareInColumn(std::size_t from, std::size_t column) const {
    if (from >= rows_.size()) return 0.0;
    std::size_t count = 0;
    for (std::size_t r = from; r < rows_.size(); ++r)
      count += looks(row(r), column) ? 1 : 0;
    return static_cast<double>(count) / static_cast<double>(rows_.size() - from);
  }

  // Longest run of rows whose field of this column is a wavelength, with something beside it.
  struct Run {
    std::size_t first = 0, count = 0;
  };
  Run longestRun(std::size_t column) const {
    Run longest, current;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      if (!looks(row(r), column) || widthOf(row(r)) < column + 2) {
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
      if (isWavelengthHeading(fieldOf(row(r), column)) && widthOf(row(r)) > column + 1) return true;
    }
    return false;
  }

  // A row below other text whose wavelengths stand side by side, above rows as wide.
  bool isRowOfWavelengths(std::size_t r) const {
    std::size_t run = 0, longest = 0, count = 0;
    for (std::size_t c = left_; c < row(r).fields.size(); ++c) {
      run = looks(row(r), c) ? run + 1 : 0;
      count += run > 0 ? 1 : 0;
      longest = std::max(longest, run);
    }
    const bool enough = longest >= kFewestInRow || (count >= 2 && shareInRow(row(r)) >= kEnough);
    return enough && r + 1 < rows_.size() && 2 * widthOf(row(r + 1)) > widthOf(row(r));
  }

  bool chooseColumn(std::size_t column, const Run& run) {
    inColumns_ = true;
    wavelengthColumn_ = column;
    run_ = run;
    return true;
  }
  bool chooseRow(std::size_t r) {
    inColumns_ = false;
    headerRow_ = r;
    return true;
  }

  // Decides where the wavelengths are; false if there are none.
  bool choose() {
    const CsvRow& first = row(0);
    const Run run = longestRun(left_);
    const double inRow = shareInRow(first), inColumn = shareInColumn(1, left_);
    if (std::max(inRow, inColumn) >= kEnough && widthOf(first) >= left_ + 2) {
      const bool tied = inRow == inColumn;
      const bool columnsWin = tied ? options_.preferred == Orientation::columns ||
                                         isWavelengthHeading(first.fields[left_])
                                   : inColumn > inRow;
      if (!columnsWin) return chooseRow(0);
      if (run.first <= 1 && run.count > 0 && !isNumbering(first)) return chooseColumn(left_, run);
    }
    return chooseBelowText(run);
  }

  // Whether a column further right is headed as wavelengths, so that the first only numbers rows.
  bool isNumbering(const CsvRow& header) const {
    if (isWavelengthHeading(fieldOf(header, left_))) return false;
    for (std::size_t c = left_ + 1; c < left_ + kMostLeadingColumns; ++c) {
      if (isWavelengthHeading(fieldOf(header, c)) && looks(row(1), c)) return true;
    }
    return false;
  }

  bool chooseBelowText(const Run& firstColumn) {
    std::size_t column = left_;
    Run run = firstColumn;
    for (std::size_t c = left_ + 1; c < left_ + kMostLeadingColumns; ++c) {
      const Run other = longestRun(c);
      const bool headed = headedAbove(other.first, c) && !headedAbove(run.first, column);
      if (other.count >= 2 && (run.count < 2 || headed)) {
        column = c;
        run = other;
      }
    }
    std::optional<std::size_t> header;
    for (std::size_t r = 0; !header && r < std::min(rows_.size(), kMostHeaderRows); ++r) {
      if (isRowOfWavelengths(r)) header = r;
    }
    const bool inColumn = run.count >= 2 || (run.count == 1 && headedAbove(run.first, column));
    if (!inColumn) return header && chooseRow(*header);
    if (!header || *header > run.first) return chooseColumn(column, run);
    // Wavelengths above numbered rows, or counts beside wavelengths.
    const double rowShare = shareInRow(row(*header));
    const double columnShare = shareInColumn(*header + 1, column);
    const bool headed = headedAbove(run.first, column);
    if (headed || columnShare > rowShare ||
        (columnShare == rowShare && options_.preferred == Orientation::columns)) {
      return chooseColumn(column, run);
    }
    return chooseRow(*header);
  }

  Error nothingFound() const {
    std::size_t widest = 0;
    for (const CsvRow* row : rows_)
      widest = std::max(widest, widthOf(*row));
    if (widest < left_ + 2) {
      return inputError(at(row(0)),
                        "there is one column only; separate wavelengths and values by commas, "
                        "semicolons or tabs");
    }
    return inputError(at(row(0)),
                      "there are no wavelengths in nm in the first row or column; where they have "
                      "another unit, name it in the heading, such as wavelength_um");
  }

  Error notAWavelength(const CsvRow& row, std::size_t column) const {
    return inputError(at(row, column),
                      echoed(fieldOf(row, column)) + " is not a wavelength; give a number in nm");
  }

  // --- One spectrum a row -------------------------------------------------------------------

  Status layOutRows() {
    const CsvRow& header = row(headerRow_);
    layout_.headerPlace = at(header);
    layout_.width_ = header.fields.size();
    std::size_t first = 0;
    // A heading that begins like a number is a misspelt one.
    while (first < header.fields.size() && !wavelengthOf(header.fields[first], format_) &&
           !beginsLikeNumber(header.fields[first])) {
      ++first;
    }
    std::size_t end = header.fields.size();
    while (end > first && !wavelengthOf(header.fields[end - 1], format_) &&
           !beginsLikeNumber(header.fields[end - 1]) && !isMissingHeading(end - 1)) {
      --end;
    }
    noteLeftOut(header, end);
    std::vector<Found> found;
    for (std::size_t c = first; c < end; ++c) {
      const auto wavelength = wavelengthOf(header.fields[c], format_);
      if (!wavelength) return notAWavelength(header, c);
      found.push_back({*wavelength, &header, c});
    }
    CUTIS_CHECK(sortWavelengths(found));
    for (const Found& one : found)
      layout_.wavelengthColumns_.push_back(one.column);
    return takeRows(first);
  }

  // An empty heading above values belongs to a wavelength that is missing.
  bool isMissingHeading(std::size_t column) const {
    if (!row(headerRow_).fields[column].empty()) return false;
    for (std::size_t r = headerRow_ + 1; r < rows_.size(); ++r) {
      if (!fieldOf(row(r), column).empty()) return true;
    }
    return false;
  }

  void noteLeftOut(const CsvRow& header, std::size_t end) {
    std::vector<std::string> names;
    for (std::size_t c = end; c < header.fields.size(); ++c) {
      if (!header.fields[c].empty()) names.emplace_back(header.fields[c]);
    }
    if (names.empty()) return;
    layout_.notes.push_back(at(header) +
                            ": columns behind the wavelengths are left out: " + listed(names));
  }

  Status takeRows(std::size_t first) {
    const CsvRow& header = row(headerRow_);
    const auto named = std::find_if(header.fields.begin(),
                                    header.fields.begin() + static_cast<std::ptrdiff_t>(first),
                                    isIdentifierHeading);
    const auto place = static_cast<std::size_t>(named - header.fields.begin());
    const std::size_t idColumn = place < first ? place : left_;
    for (std::size_t r = headerRow_ + 1; r < rows_.size(); ++r) {
      if (widthOf(row(r)) > header.fields.size()) return wrongWidth(row(r));
      layout_.spectrumRows_.push_back(&row(r));
      layout_.names.emplace_back(first > 0 ? fieldOf(row(r), idColumn) : std::string_view());
    }
    if (layout_.names.empty()) {
      return inputError(place_, "there are no spectra below the wavelengths");
    }
    return {};
  }

  Error wrongWidth(const CsvRow& wide) const {
    return inputError(at(wide), "the row has " + std::to_string(wide.fields.size()) +
                                    " fields where the header has " +
                                    std::to_string(layout_.width_) +
                                    "; complete or correct it, and write numbers with points where "
                                    "commas separate them");
  }

  // --- One spectrum a column ----------------------------------------------------------------

  Status layOutColumns() {
    std::vector<Found> found;
    CUTIS_CHECK(collectColumn(found));
    keepOneSection(found);
    CUTIS_CHECK(sortWavelengths(found));
    std::size_t width = 0;
    for (const Found& one : found) {
      layout_.wavelengthRows_.push_back(one.row);
      width = std::max(width, widthOf(*one.row));
    }
    return nameColumns(width);
  }

  bool isPlain(const CsvRow& row) const { return isNumber(fieldOf(row, wavelengthColumn_)); }

  // Something that looks like a row of data, whatever its wavelength is.
  bool looksLikeData(const CsvRow& candidate) const {
    if (widthOf(candidate) < wavelengthColumn_ + 2) return false;
    for (std::size_t c = wavelengthColumn_ + 1; c < candidate.fields.size(); ++c) {
      if (!candidate.fields[c].empty() && isNumber(candidate.fields[c])) return true;
    }
    return false;
  }

  struct Found {
    double wavelengthNm = 0.0;
    const CsvRow* row = nullptr;
    std::size_t column = 0;
  };

  // Rows with wavelengths. Plain numbers stand together, and what is between or beside them must be
  // one, too; cells with units or labels may stand between other entries of an instrument.
  Status collectColumn(std::vector<Found>& found) {
    const bool plain = isPlain(row(run_.first));
    firstRow_ = plain ? firstPlainRow() : 0;
    if (plain && firstRow_ > 0 && looksLikeData(row(firstRow_ - 1)) &&
        beginsLikeNumber(fieldOf(row(firstRow_ - 1), wavelengthColumn_)) &&
        widthOf(row(firstRow_ - 1)) == widthOf(row(firstRow_))) {
      return notAWavelength(row(firstRow_ - 1), wavelengthColumn_);
    }
    for (std::size_t r = firstRow_; r < rows_.size(); ++r) {
      const std::string_view field = fieldOf(row(r), wavelengthColumn_);
      const auto wavelength = wavelengthOf(field, format_);
      const bool isOne =
          wavelength && (plain || (!isNumber(field) && looks(row(r), wavelengthColumn_)));
      if (isOne) {
        if (found.empty()) firstRow_ = r;
        found.push_back({*wavelength, &row(r), wavelengthColumn_});
      } else if (plain ? r < run_.first + run_.count || looksLikeData(row(r))
                       : beginsLikeNumber(field) && looksLikeData(row(r)) && !isNumber(field)) {
        return notAWavelength(row(r), wavelengthColumn_);
      }
    }
    return {};
  }

  // From the first row of data, as wide as those of the longest run.
  std::size_t firstPlainRow() const {
    for (std::size_t r = 0; r < run_.first; ++r) {
      if (isPlain(row(r)) && looks(row(r), wavelengthColumn_) && looksLikeData(row(r)) &&
          widthOf(row(r)) == widthOf(row(run_.first))) {
        return r;
      }
    }
    return run_.first;
  }

  // An instrument that writes its spectrum twice, in coarser and in finer steps, begins anew.
  void keepOneSection(std::vector<Found>& found) {
    if (found.empty() || isPlain(*found.front().row)) return;
    std::vector<std::size_t> starts = {0};
    for (std::size_t i = 1; i < found.size(); ++i) {
      if (found[i].wavelengthNm <= found[starts.back()].wavelengthNm &&
          found[i].wavelengthNm < found[i - 1].wavelengthNm &&
          found[starts.back()].wavelengthNm < found[i - 1].wavelengthNm) {
        starts.push_back(i);
      }
    }
    if (starts.size() < 2) return;
    starts.push_back(found.size());
    std::size_t best = 0;
    for (std::size_t s = 1; s + 1 < starts.size(); ++s) {
      if (starts[s + 1] - starts[s] > starts[best + 1] - starts[best]) best = s;
    }
    const auto begin = found.begin();
    found = std::vector<Found>(begin + static_cast<std::ptrdiff_t>(starts[best]),
                               begin + static_cast<std::ptrdiff_t>(starts[best + 1]));
    layout_.notes.push_back(at(*found.front().row) + ": of " + std::to_string(starts.size() - 1) +
                            " sections of wavelengths the one with the most, " +
                            std::to_string(found.size()) + ", is read");
  }

  // The row with the names of the columns, if there is one.
  const CsvRow* namesRow(std::size_t width) {
    const auto isNames = [&](const CsvRow& candidate) {
      if (widthOf(candidate) < wavelengthColumn_ + 2) return false;
      for (std::size_t c = wavelengthColumn_ + 1; c < width; ++c) {
        if (isUnitOnly(fieldOf(candidate, c))) continue;
        return !fieldOf(candidate, c).empty();
      }
      return false;
    };
    for (std::size_t r = firstRow_; r-- > 0;) {
      const std::string first = loweredText(fieldOf(row(r), wavelengthColumn_));
      const bool headed = isWavelengthHeading(first) || isIdentifierHeading(first) ||
                          first == "data name" || first == "title" || first == "sample name";
      // Beside cells with units a number is a reading of the instrument and no name.
      if (headed && isNames(row(r)) && (isPlain(row(firstRow_)) || !looksLikeData(row(r)))) {
        return &row(r);
      }
    }
    if (firstRow_ == 0) return nullptr;
    const CsvRow& above = row(firstRow_ - 1);
    const bool isHeader = firstRow_ == 1 || (isPlain(row(firstRow_)) && isNames(above) &&
                                             widthOf(above) == width && !looksLikeData(above));
    return isHeader ? &above : nullptr;
  }

  Status nameColumns(std::size_t width) {
    const CsvRow* names = namesRow(width);
    const CsvRow& header = names != nullptr ? *names : row(firstRow_);
    layout_.headerPlace = at(header);
    layout_.width_ = header.fields.size();
    if (names != nullptr) {
      width = std::max(width, widthOf(*names));
      // A name is left out where the last columns have none, and so is its separator.
      if (width > names->fields.size() && (firstRow_ == 1 || !namesUnits())) {
        for (const CsvRow* row : layout_.wavelengthRows_) {
          if (widthOf(*row) > names->fields.size()) return wrongWidth(*row);
        }
      }
      if (firstRow_ == 1) width = std::max(width, usedWidth(*names));
    } else {
      for (const CsvRow* row : layout_.wavelengthRows_) {
        if (widthOf(*row) > header.fields.size()) return wrongWidth(*row);
      }
    }
    if (width < wavelengthColumn_ + 2) {
      return inputError(layout_.headerPlace,
                        "there is one column only; separate wavelengths and values by commas, "
                        "semicolons or tabs");
    }
    return chooseColumns(names, width);
  }

  bool namesUnits() const {
    return firstRow_ > 0 && isUnitOnly(fieldOf(row(firstRow_ - 1), wavelengthColumn_));
  }

  // Columns that at least one row has a value in.
  std::size_t usedWidth(const CsvRow& names) const {
    std::size_t width = widthOf(names);
    for (const CsvRow* row : layout_.wavelengthRows_)
      width = std::max(width, widthOf(*row));
    return width;
  }

  std::string_view unitBelow(const CsvRow* names, std::size_t column) const {
    if (firstRow_ == 0 || !namesUnits() || &row(firstRow_ - 1) == names) return {};
    return fieldOf(row(firstRow_ - 1), column);
  }

  bool isEmptyColumn(std::size_t column) const {
    return std::all_of(layout_.wavelengthRows_.begin(), layout_.wavelengthRows_.end(),
                       [&](const CsvRow* row) { return fieldOf(*row, column).empty(); });
  }

  Status chooseColumns(const CsvRow* names, std::size_t width) {
    std::vector<std::string> counts;
    for (std::size_t c = wavelengthColumn_ + 1; c < width; ++c) {
      const std::string_view name = names != nullptr ? fieldOf(*names, c) : std::string_view();
      const std::string_view unit = unitBelow(names, c);
      if (name.empty() && isEmptyColumn(c)) continue;
      if (saysCounts(unit) || saysCounts(name)) {
        counts.emplace_back(name);
        continue;
      }
      if (unit.find('%') != std::string_view::npos || name.find('%') != std::string_view::npos) {
        layout_.saysPercent = true;
      }
      layout_.spectrumColumns_.push_back(c);
      layout_.names.emplace_back(name);
    }
    if (layout_.names.empty() && !counts.empty()) {
      return inputError(layout_.headerPlace, "all columns are counts of the detector (" +
                                                 listed(counts) +
                                                 "); export what was calculated from them");
    }
    if (!counts.empty()) {
      layout_.notes.push_back(layout_.headerPlace +
                              ": counts of the detector are left out: " + listed(counts));
    }
    return {};
  }

  // --- Both ---------------------------------------------------------------------------------

  // Into increasing order, if they increase or decrease throughout.
  Status sortWavelengths(std::vector<Found>& found) {
    std::size_t up = 0, down = 0;
    for (std::size_t i = 1; i < found.size(); ++i) {
      up += found[i].wavelengthNm > found[i - 1].wavelengthNm ? 1 : 0;
      down += found[i].wavelengthNm < found[i - 1].wavelengthNm ? 1 : 0;
    }
    const bool falling = down > up;
    for (std::size_t i = 1; i < found.size(); ++i) {
      const double before = found[i - 1].wavelengthNm, here = found[i].wavelengthNm;
      if (falling ? here < before : here > before) continue;
      return inputError(at(*found[i].row, found[i].column),
                        "the wavelength " + formatNumber(here) + " comes after " +
                            formatNumber(before) + "; sort them so that each appears once");
    }
    if (falling) std::reverse(found.begin(), found.end());
    for (const Found& one : found)
      layout_.wavelengthsNm.push_back(one.wavelengthNm);
    return {};
  }

  // A heading that names another unit than the numbers have.
  Status checkScale() const {
    if (layout_.wavelengthsNm.empty() || format_.unit == WavelengthUnit::nanometres) return {};
    const double most = layout_.wavelengthsNm.back(), least = layout_.wavelengthsNm.front();
    if (most >= kLeastWavelengthNm && least <= kImplausibleNm) return {};
    return inputError(unitPlace_, "by the unit in this heading the wavelengths are " +
                                      formatNumber(least) + " to " + formatNumber(most) +
                                      " nm; correct the unit");
  }

  LayoutOptions options_;
  const std::string& place_;
  WavelengthFormat format_;
  std::string unitPlace_;
  std::vector<const CsvRow*> rows_;
  std::size_t left_ = 0;
  bool inColumns_ = false;
  std::size_t headerRow_ = 0;
  std::size_t wavelengthColumn_ = 0;
  Run run_;
  std::size_t firstRow_ = 0;
  SpectralLayout layout_;
};

std::string SpectralLayout::placeOf(std::size_t spectrum, std::size_t wavelength) const {
  return place_ + ":" + std::to_string(rowAt(spectrum, wavelength).line) + ", column " +
         std::to_string(columnAt(spectrum, wavelength) + 1);
}

Error SpectralLayout::shortRow(std::size_t spectrum, std::size_t wavelength) const {
  const CsvRow& row = rowAt(spectrum, wavelength);
  return inputError(place_ + ":" + std::to_string(row.line),
                    "the row has " + std::to_string(row.fields.size()) +
                        " fields where the header has " + std::to_string(width_) +
                        "; complete or correct it");
}

Result<SpectralLayout> findLayout(const CsvTable& table, const NumberFormat& numbers,
                                  const LayoutOptions& options, const std::string& place) {
  return LayoutFinder(table, numbers, options, place).find();
}

}  // namespace cutis
