#include "src/files/spectra/spectral_layout.h"

#include <algorithm>
#include <optional>

#include "core/base/number_text.h"
#include "src/files/spectra/percent_words.h"

namespace cutis {

namespace {

// No wavelength of light that a heading in micrometres could mean.
constexpr double kImplausibleNm = 50000.0;

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
      : options_(options), place_(place), filled_(table) {
    format_.numbers = numbers;
    format_.labelled = options.labelled;
    layout_.place_ = place;
  }

  Result<SpectralLayout> find() {
    if (rows_.empty()) return inputError(place_, "the file has no rows; begin with wavelengths");
    CUTIS_CHECK(takeUnit());
    auto found = findWavelengths(filled_, options_.preferred);
    if (!found) {
      format_.labelled = true;
      found = findWavelengths(filled_, options_.preferred);
    }
    if (!found) return nothingFound();
    wavelengths_ = *found;
    layout_.inColumns_ = wavelengths_.inColumn;
    CUTIS_CHECK(wavelengths_.inColumn ? layOutColumns() : layOutRows());
    CUTIS_CHECK(checkScale());
    return std::move(layout_);
  }

 private:
  const CsvRow& row(std::size_t r) const { return filled_.row(r); }
  bool looks(const CsvRow& row, std::size_t column) const { return filled_.looks(row, column); }
  bool isNumber(std::string_view field) const { return filled_.isNumber(field); }

  std::string at(const CsvRow& row) const { return place_ + ":" + std::to_string(row.line); }
  std::string at(const CsvRow& row, std::size_t column) const {
    return at(row) + ", column " + std::to_string(column + 1);
  }

  // The lowest heading above the numbers that names a unit.
  Status takeUnit() {
    for (std::size_t r = 0; r < std::min(rows_.size(), kMostHeaderRows); ++r) {
      for (std::size_t c = filled_.left; c < filled_.left + kMostLeadingColumns; ++c) {
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

  Error nothingFound() const {
    std::size_t widest = 0;
    for (const CsvRow* row : rows_)
      widest = std::max(widest, widthOf(*row));
    if (widest < filled_.left + 2) {
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
    const CsvRow& header = row(wavelengths_.headerRow);
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
    const auto names = std::span(header.fields).first(first);
    if (std::any_of(names.begin(), names.end(), declaresPercent))
      layout_.percentPlace = layout_.headerPlace;
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
    if (!row(wavelengths_.headerRow).fields[column].empty()) return false;
    for (std::size_t r = wavelengths_.headerRow + 1; r < rows_.size(); ++r) {
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
    const CsvRow& header = row(wavelengths_.headerRow);
    const auto named = std::find_if(header.fields.begin(),
                                    header.fields.begin() + static_cast<std::ptrdiff_t>(first),
                                    isIdentifierHeading);
    const auto place = static_cast<std::size_t>(named - header.fields.begin());
    const std::size_t idColumn = place < first ? place : filled_.left;
    for (std::size_t r = wavelengths_.headerRow + 1; r < rows_.size(); ++r) {
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

  bool isPlain(const CsvRow& row) const { return isNumber(fieldOf(row, wavelengths_.column)); }

  // Something that looks like a row of data, whatever its wavelength is.
  bool looksLikeData(const CsvRow& candidate) const {
    if (widthOf(candidate) < wavelengths_.column + 2) return false;
    for (std::size_t c = wavelengths_.column + 1; c < candidate.fields.size(); ++c) {
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
    const bool plain = isPlain(row(wavelengths_.run.first));
    firstRow_ = plain ? firstPlainRow() : 0;
    if (plain && firstRow_ > 0 && looksLikeData(row(firstRow_ - 1)) &&
        beginsLikeNumber(fieldOf(row(firstRow_ - 1), wavelengths_.column)) &&
        widthOf(row(firstRow_ - 1)) == widthOf(row(firstRow_))) {
      return notAWavelength(row(firstRow_ - 1), wavelengths_.column);
    }
    for (std::size_t r = firstRow_; r < rows_.size(); ++r) {
      const std::string_view field = fieldOf(row(r), wavelengths_.column);
      const auto wavelength = wavelengthOf(field, format_);
      const bool isOne =
          wavelength && (plain || (!isNumber(field) && looks(row(r), wavelengths_.column)));
      if (isOne) {
        if (found.empty()) firstRow_ = r;
        found.push_back({*wavelength, &row(r), wavelengths_.column});
      } else if (plain
                     ? r < wavelengths_.run.first + wavelengths_.run.count || looksLikeData(row(r))
                     : beginsLikeNumber(field) && looksLikeData(row(r)) && !isNumber(field)) {
        return notAWavelength(row(r), wavelengths_.column);
      }
    }
    return {};
  }

  // From the first row of data, as wide as those of the longest run.
  std::size_t firstPlainRow() const {
    for (std::size_t r = 0; r < wavelengths_.run.first; ++r) {
      if (isPlain(row(r)) && looks(row(r), wavelengths_.column) && looksLikeData(row(r)) &&
          widthOf(row(r)) == widthOf(row(wavelengths_.run.first))) {
        return r;
      }
    }
    return wavelengths_.run.first;
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
      if (widthOf(candidate) < wavelengths_.column + 2) return false;
      for (std::size_t c = wavelengths_.column + 1; c < width; ++c) {
        if (isUnitOnly(fieldOf(candidate, c))) continue;
        return !fieldOf(candidate, c).empty();
      }
      return false;
    };
    for (std::size_t r = firstRow_; r-- > 0;) {
      const std::string first = loweredText(fieldOf(row(r), wavelengths_.column));
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
    if (width < wavelengths_.column + 2) {
      return inputError(layout_.headerPlace,
                        "there is one column only; separate wavelengths and values by commas, "
                        "semicolons or tabs");
    }
    return chooseColumns(names, width);
  }

  bool namesUnits() const {
    return firstRow_ > 0 && isUnitOnly(fieldOf(row(firstRow_ - 1), wavelengths_.column));
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
    for (std::size_t c = wavelengths_.column + 1; c < width; ++c) {
      const std::string_view name = names != nullptr ? fieldOf(*names, c) : std::string_view();
      const std::string_view unit = unitBelow(names, c);
      if (name.empty() && isEmptyColumn(c)) continue;
      if (saysCounts(unit) || saysCounts(name)) {
        counts.emplace_back(name);
        continue;
      }
      if (declaresPercent(name)) layout_.percentPlace = layout_.headerPlace;
      if (declaresPercent(unit)) layout_.percentPlace = at(row(firstRow_ - 1));
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
  FilledTable filled_;
  WavelengthFormat& format_ = filled_.format;
  const std::vector<const CsvRow*>& rows_ = filled_.rows;
  std::string unitPlace_;
  WavelengthPlace wavelengths_;
  std::size_t firstRow_ = 0;
  SpectralLayout layout_;
};

int SpectralLayout::firstLine() const {
  const std::vector<const CsvRow*>& rows = inColumns_ ? wavelengthRows_ : spectrumRows_;
  const auto first = std::min_element(
      rows.begin(), rows.end(), [](const CsvRow* a, const CsvRow* b) { return a->line < b->line; });
  return (*first)->line;
}

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
