#include "src/files/spectra/spectra_text.h"

#include <cmath>
#include <utility>

#include "src/files/spectra/cgats.h"
#include "src/files/spectra/percent_words.h"
#include "src/files/spectra/text_encoding.h"

namespace cutis {
namespace {

// Fields in the text's own separators.
Result<CsvTable> fieldsOfText(std::string_view text, NumberFormat& numbers,
                              const std::string& place) {
  const char separator = separatorOf(text);
  CsvTable table = splitCsv(text, separator);
  if (table.unclosedQuoteLine() > 0) {
    return inputError(place + ":" + std::to_string(table.unclosedQuoteLine()),
                      "a quote opens here that is never closed; close or remove it");
  }
  numbers = NumberFormat(text, table, separator);
  return table;
}

}  // namespace

Result<SpectraText> takeApart(std::string bytes, const LayoutOptions& options,
                              const std::string& place) {
  SpectraText result;
  CUTIS_TRY(decoded, decodedText(std::move(bytes), place));
  result.text = std::make_unique<const std::string>(std::move(decoded.text));
  LayoutOptions asked = options;
  std::size_t tables = 1;
  if (isCgats(*result.text)) {
    CUTIS_TRY(cgats, splitCgats(*result.text, place));
    result.source = std::move(cgats.source);
    result.table = std::move(cgats.table);
    tables = cgats.tables;
    asked.labelled = true;
  } else {
    CUTIS_TRY(table, fieldsOfText(*result.text, result.numbers, place));
    result.table = std::move(table);
  }
  CUTIS_TRY(layout, findLayout(result.table, result.numbers, asked, place));
  result.layout = std::move(layout);
  SpectralLayout& found = result.layout;
  if (found.percentPlace.empty()) {
    if (const auto line = percentLineAbove(*result.text, found.firstLine()))
      found.percentPlace = place + ":" + std::to_string(*line);
  }
  if (decoded.isGuessed) {
    found.notes.push_back(place + ": the text is not UTF-8 and is read as Windows-1252");
  }
  if (tables > 1) {
    found.notes.push_back(place + ": of " + std::to_string(tables) +
                          " tables of spectra the first is read");
  }
  return result;
}

Result<double> numberIn(const SpectraText& spectra, std::size_t spectrum, std::size_t wavelength) {
  const SpectralLayout& layout = spectra.layout;
  if (!layout.has(spectrum, wavelength)) return layout.shortRow(spectrum, wavelength);
  const std::string_view field = layout.cell(spectrum, wavelength);
  auto number = spectra.numbers.parse(field);
  if (!number && field.ends_with('%')) {
    number = spectra.numbers.parse(field.substr(0, field.size() - 1));
    if (number) number = *number / 100.0;
  }
  if (number && std::isfinite(*number)) return *number;
  return inputError(layout.placeOf(spectrum, wavelength),
                    number ? echoed(field) + " is not a finite number; correct it"
                           : spectra.numbers.objection(field));
}

}  // namespace cutis
