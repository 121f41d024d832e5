#include "src/files/spectra/spectral_csv.h"

#include <optional>
#include <utility>

#include "core/spectra/grid.h"
#include "src/files/io/text_file.h"
#include "src/files/spectra/spectra_text.h"

namespace cutis {
namespace {

// The values of all curves at one wavelength; nothing if one is bad where none is needed.
Result<std::optional<std::vector<double>>> valuesAt(const SpectraText& file, std::size_t w) {
  const double wavelengthNm = file.layout.wavelengthsNm[w];
  const bool needed = wavelengthNm >= kFirstWavelengthNm && wavelengthNm <= kLastWavelengthNm;
  std::vector<double> values;
  for (std::size_t s = 0; s < file.layout.spectrumCount(); ++s) {
    const auto value = numberIn(file, s, w);
    if (!value && needed) return value.failure();
    if (!value) return std::optional<std::vector<double>>();
    values.push_back(value.value());
  }
  return std::optional(std::move(values));
}

Result<SpectralTable> curves(std::string bytes, const std::string& place) {
  LayoutOptions options;
  options.preferred = Orientation::columns;
  CUTIS_TRY(file, takeApart(std::move(bytes), options, place));
  SpectralTable table;
  table.place = place;
  table.names = file.layout.names;
  table.notes = file.layout.notes;
  table.columns.resize(table.names.size());
  for (std::size_t w = 0; w < file.layout.wavelengthCount(); ++w) {
    CUTIS_TRY(values, valuesAt(file, w));
    if (!values) continue;
    table.wavelengthsNm.push_back(file.layout.wavelengthsNm[w]);
    for (std::size_t c = 0; c < values->size(); ++c)
      table.columns[c].push_back((*values)[c]);
  }
  if (table.wavelengthsNm.size() >= 2) return table;
  return inputError(file.layout.headerPlace,
                    "a curve needs at least two wavelengths with values; add them");
}

}  // namespace

Result<SpectralTable> parseSpectralCsv(std::string_view text, const std::string& place) {
  return curves(std::string(text), place);
}

Result<SpectralTable> readSpectralCsv(const std::filesystem::path& path) {
  CUTIS_TRY(text, readTextFile(path));
  return curves(std::move(text), path.string());
}

}  // namespace cutis
