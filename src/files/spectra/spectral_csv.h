#pragma once

// Curves over wavelength, of lights, cameras, observers, displays and chromophores, from what
// spreadsheets and instruments write: as src/files/spectra/measured_spectra_file.h, and where both
// a row and a column read as wavelengths, the column is meant.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/spectra/spectral_curve.h"

namespace cutis {

struct SpectralTable {
  std::string place;                         // for errors
  std::vector<std::string> names;            // of the curves, from the header; may be empty
  std::vector<double> wavelengthsNm;         // strictly increasing, at least two
  std::vector<std::vector<double>> columns;  // one per name, finite
  std::vector<std::string> notes;            // sentences on what was left out

  Spectrum onGrid(std::size_t column) const { return resample({wavelengthsNm, columns[column]}); }
};

// Wavelengths outside 300 to 1000 nm at which a value is missing or no number are left out.
Result<SpectralTable> parseSpectralCsv(std::string_view text, const std::string& place);
Result<SpectralTable> readSpectralCsv(const std::filesystem::path& path);

}  // namespace cutis
