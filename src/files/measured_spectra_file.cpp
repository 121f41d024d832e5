#include "src/files/measured_spectra_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "core/base/echoed_text.h"
#include "core/base/number_text.h"
#include "src/files/io/csv.h"
#include "src/files/io/text_file.h"

namespace cutis {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30;
// Less is an ordinal number, or a wavelength in micrometres.
constexpr double kLeastWavelengthNm = 100.0;

std::string lowered(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

// "380", "380nm", "380 nm"; not finite: none.
std::optional<double> wavelengthOf(std::string_view field) {
  if (lowered(field).ends_with("nm")) {
    field.remove_suffix(2);
    while (field.ends_with(' '))
      field.remove_suffix(1);
  }
  const auto number = parseNumber(field);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

bool looksLikeWavelength(std::string_view field) {
  return wavelengthOf(field).value_or(0.0) >= kLeastWavelengthNm;
}

bool isWavelengthHeading(std::string_view field) {
  const std::string name = lowered(field);
  return name.starts_with("wavelength") || name.starts_with("lambda") || name.starts_with("nm") ||
         name == "wl";
}

bool isIdentifierHeading(std::string_view field) {
  constexpr std::array<std::string_view, 6> kNames = {"id",      "name",   "sample",
                                                      "subject", "record", "label"};
  return std::find(kNames.begin(), kNames.end(), lowered(field)) != kNames.end();
}

class Reader {
 public:
  Reader(const std::vector<CsvRow>& rows, const std::string& place, const WavelengthRange& range,
         std::size_t fewest, const JobContext& context)
      : rows_(rows), place_(place), range_(range), fewest_(fewest), context_(context) {}

  Result<MeasuredSpectra> read() {
    if (rows_.empty()) return inputError(place_, "the file has no rows; begin with wavelengths");
    CUTIS_CHECK(checkSeparator());
    CUTIS_TRY(inColumns, spectraAreColumns());
    CUTIS_CHECK(checkWidths());
    CUTIS_CHECK(inColumns ? readColumns() : readRows());
    return std::move(spectra_);
  }

 private:
  const CsvRow& header() const { return rows_.front(); }

  std::string at(const CsvRow& row) const { return place_ + ":" + std::to_string(row.line); }
  std::string at(const CsvRow& row, std::size_t column) const {
    return at(row) + ", column " + std::to_string(column + 1);
  }

  Status checkSeparator() const {
    for (const std::string_view field : header().fields) {
      if (field.find_first_of(";\t") == std::string_view::npos) continue;
      return inputError(at(header()),
                        "fields are separated by semicolons or tabs; separate them by commas and "
                        "write numbers with points");
    }
    if (header().fields.size() > 1) return {};
    return inputError(at(header()),
                      "there is one column only; separate wavelengths and values by commas");
  }

  Result<bool> spectraAreColumns() const {
    const auto& fields = header().fields;
    const auto inRow = std::count_if(fields.begin() + 1, fields.end(), looksLikeWavelength);
    const auto inColumn = std::count_if(rows_.begin() + 1, rows_.end(), [](const CsvRow& row) {
      return looksLikeWavelength(row.fields.front());
    });
    const double rowShare = static_cast<double>(inRow) / static_cast<double>(fields.size() - 1);
    const double columnShare =
        rows_.size() > 1 ? static_cast<double>(inColumn) / static_cast<double>(rows_.size() - 1)
                         : 0.0;
    if (std::max(rowShare, columnShare) < 0.5) {
      return inputError(at(header()),
                        "there are no wavelengths in the first row or column; give them in nm");
    }
    if (rowShare != columnShare) return columnShare > rowShare;
    return isWavelengthHeading(fields.front());
  }

  Status checkWidths() const {
    for (const CsvRow& row : rows_) {
      if (row.fields.size() == header().fields.size()) continue;
      return inputError(at(row), "the row has " + std::to_string(row.fields.size()) +
                                     " fields where the first row has " +
                                     std::to_string(header().fields.size()) +
                                     "; complete or correct it");
    }
    return {};
  }

  Result<double> readWavelength(const CsvRow& row, std::size_t column,
                                std::optional<double> before) const {
    const std::string_view field = row.fields[column];
    const auto wavelength = wavelengthOf(field);
    if (!wavelength) {
      return inputError(at(row, column),
                        inQuotes(std::string(field)) + " is not a wavelength; give a number in nm");
    }
    if (before && *wavelength <= *before) {
      return inputError(at(row, column), "the wavelength " + formatNumber(*wavelength) +
                                             " comes after " + formatNumber(*before) +
                                             "; sort them so that each appears once");
    }
    return *wavelength;
  }

  Status checkCount() const {
    const std::size_t count = spectra_.wavelengthsNm.size();
    if (count >= fewest_) return {};
    return inputError(at(header()), "too few wavelengths lie from " + formatNumber(range_.fromNm) +
                                        " to " + formatNumber(range_.toNm) +
                                        " nm: " + std::to_string(count) + " where at least " +
                                        std::to_string(fewest_) + " are needed");
  }

  Result<double> readValue(const CsvRow& row, std::size_t column, bool used) const {
    const std::string_view field = row.fields[column];
    const auto value = parseNumber(field);
    if (!value || !std::isfinite(*value)) {
      return inputError(at(row, column),
                        inQuotes(std::string(field)) + " is not a finite number; correct it");
    }
    if (used && *value < 0.0) {
      return inputError(at(row, column),
                        "the reflectance " + formatNumber(*value) +
                            " is negative; correct it or leave its wavelength out");
    }
    if (used && *value > kMostReflectance) {
      return inputError(at(row, column),
                        "the reflectance " + formatNumber(*value) +
                            " is not a share from 0 to 1; divide percentages by 100");
    }
    return *value;
  }

  void addId(std::string_view name) {
    spectra_.ids.emplace_back(name.empty() ? std::to_string(spectra_.ids.size() + 1)
                                           : std::string(name));
  }

  Status readRows() {
    const auto& fields = header().fields;
    std::size_t first = 0;
    // A heading that begins like a number is a misspelt one.
    while (first < fields.size() && !wavelengthOf(fields[first]) &&
           (fields[first].empty() ||
            std::isdigit(static_cast<unsigned char>(fields[first].front())) == 0)) {
      ++first;
    }
    const auto named = std::find_if(
        fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(first), isIdentifierHeading);
    const auto place = static_cast<std::size_t>(named - fields.begin());
    const std::size_t idColumn = place < first ? place : 0;
    std::vector<bool> used(fields.size(), false);
    std::optional<double> before;
    for (std::size_t c = first; c < fields.size(); ++c) {
      CUTIS_TRY(wavelength, readWavelength(header(), c, before));
      before = wavelength;
      used[c] = range_.contains(wavelength);
      if (used[c]) spectra_.wavelengthsNm.push_back(wavelength);
    }
    CUTIS_CHECK(checkCount());
    if (rows_.size() < 2) return inputError(place_, "there are no spectra below the wavelengths");
    spectra_.reflectances.reserve(spectra_.wavelengthsNm.size() * (rows_.size() - 1));
    for (std::size_t r = 1; r < rows_.size(); ++r) {
      if (context_.stopRequested()) return Cancelled{};
      addId(first > 0 ? rows_[r].fields[idColumn] : std::string_view());
      for (std::size_t c = first; c < fields.size(); ++c) {
        CUTIS_TRY(value, readValue(rows_[r], c, used[c]));
        if (used[c]) spectra_.reflectances.push_back(value);
      }
    }
    return {};
  }

  Status readColumns() {
    const std::size_t count = header().fields.size() - 1;
    const bool hasNames = !wavelengthOf(header().fields.front());
    for (std::size_t s = 0; s < count; ++s) {
      addId(hasNames ? header().fields[s + 1] : std::string_view());
    }
    std::vector<double> byWavelength;
    std::optional<double> before;
    for (std::size_t r = hasNames ? 1 : 0; r < rows_.size(); ++r) {
      if (context_.stopRequested()) return Cancelled{};
      CUTIS_TRY(wavelength, readWavelength(rows_[r], 0, before));
      before = wavelength;
      const bool used = range_.contains(wavelength);
      if (used) spectra_.wavelengthsNm.push_back(wavelength);
      for (std::size_t s = 0; s < count; ++s) {
        CUTIS_TRY(value, readValue(rows_[r], s + 1, used));
        if (used) byWavelength.push_back(value);
      }
    }
    CUTIS_CHECK(checkCount());
    const std::size_t wavelengths = spectra_.wavelengthsNm.size();
    spectra_.reflectances.resize(byWavelength.size());
    for (std::size_t w = 0; w < wavelengths; ++w) {
      for (std::size_t s = 0; s < count; ++s) {
        spectra_.reflectances[s * wavelengths + w] = byWavelength[w * count + s];
      }
    }
    return {};
  }

  const std::vector<CsvRow>& rows_;
  const std::string& place_;
  const WavelengthRange& range_;
  const std::size_t fewest_;
  const JobContext& context_;
  MeasuredSpectra spectra_;
};

}  // namespace

Result<MeasuredSpectra> parseMeasuredSpectra(std::string_view text, const std::string& place,
                                             const WavelengthRange& range, std::size_t fewest,
                                             const JobContext& context) {
  const std::vector<CsvRow> rows = splitCsv(text);
  return Reader(rows, place, range, fewest, context).read();
}

Result<MeasuredSpectra> readMeasuredSpectra(const std::filesystem::path& path,
                                            const WavelengthRange& range, std::size_t fewest,
                                            const JobContext& context) {
  CUTIS_TRY(text, readTextFile(path, kLargestFile));
  return parseMeasuredSpectra(text, path.string(), range, fewest, context);
}

}  // namespace cutis
