#pragma once  // internal to src/files

// Spectra as comma-separated values: `#` comments, a header row, the wavelength in nm in the first
// column and one curve in each of the others.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/spectra/spectral_curve.h"

namespace cutis {

struct SpectralTable {
  std::string place;                         // for errors
  std::vector<std::string> names;            // of the curves, from the header
  std::vector<double> wavelengthsNm;         // strictly increasing, at least two
  std::vector<std::vector<double>> columns;  // one per name, finite

  Spectrum onGrid(std::size_t column) const { return resample({wavelengthsNm, columns[column]}); }
};

Result<SpectralTable> parseSpectralCsv(std::string_view text, const std::string& place);
Result<SpectralTable> readSpectralCsv(const std::filesystem::path& path);

}  // namespace cutis
