#include "src/files/spectral_csv.h"

#include <cmath>

#include "core/base/echoed_text.h"
#include "core/base/number_text.h"
#include "src/files/io/csv.h"
#include "src/files/io/text_file.h"

namespace cutis {
namespace {

std::string at(const std::string& place, const CsvRow& row, std::size_t column) {
  return place + ":" + std::to_string(row.line) + ", column " + std::to_string(column + 1);
}

}  // namespace

Result<SpectralTable> parseSpectralCsv(std::string_view text, const std::string& place) {
  const std::vector<CsvRow> rows = splitCsv(text);
  if (rows.size() < 3) {
    return inputError(place, "a spectrum needs a header and at least two rows of wavelength,value");
  }
  const CsvRow& header = rows.front();
  if (header.fields.size() < 2) {
    return inputError(place + ":" + std::to_string(header.line),
                      "there is one column only; separate wavelength and values by commas");
  }
  if (parseNumber(header.fields.front())) {
    return inputError(place + ":" + std::to_string(header.line),
                      "the header is missing; begin with a line such as wavelength_nm,power");
  }
  SpectralTable table;
  table.place = place;
  table.names.assign(header.fields.begin() + 1, header.fields.end());
  table.columns.resize(table.names.size());
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const CsvRow& row = rows[r];
    if (row.fields.size() != header.fields.size()) {
      return inputError(place + ":" + std::to_string(row.line),
                        "this row has " + std::to_string(row.fields.size()) +
                            " values where the header names " +
                            std::to_string(header.fields.size()) + "; complete or correct it");
    }
    for (std::size_t c = 0; c < row.fields.size(); ++c) {
      const auto value = parseNumber(row.fields[c]);
      if (!value || !std::isfinite(*value)) {
        return inputError(at(place, row, c), inQuotes(std::string(row.fields[c])) +
                                                 " is not a finite number; correct it");
      }
      (c == 0 ? table.wavelengthsNm : table.columns[c - 1]).push_back(*value);
    }
    const std::size_t n = table.wavelengthsNm.size();
    if (n > 1 && table.wavelengthsNm[n - 1] <= table.wavelengthsNm[n - 2]) {
      return inputError(at(place, row, 0),
                        "wavelengths must increase from row to row; sort the file");
    }
  }
  return table;
}

Result<SpectralTable> readSpectralCsv(const std::filesystem::path& path) {
  CUTIS_TRY(text, readTextFile(path));
  return parseSpectralCsv(text, path.string());
}

}  // namespace cutis
