#pragma once

// Measured reflectance spectra as comma-separated values, one spectrum a row or one a column.
//
// Wavelengths in nm stand in the first row or in the first column, whichever reads as wavelengths
// (numbers from 100, "380 nm" too); where both do, the first row, unless the first field says
// "wavelength" or "nm". They increase, at any distances. A row's leading columns whose heading is
// no number name the spectrum: the one called id, name, sample, subject, record or label, else the
// first. In columns the first row holds the names. Spectra without a name are numbered from 1.
// Comments, blanks, quotes, line ends and byte order marks are as in src/files/io/csv.h.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/spectra/grid.h"

namespace cutis {

struct WavelengthRange {
  double fromNm = 400.0;
  double toNm = 700.0;  // both ends included
};

struct MeasuredSpectra {
  std::vector<std::string> ids;       // one per spectrum, not empty, not necessarily different
  std::vector<double> wavelengthsNm;  // strictly increasing, within the range
  std::vector<double> reflectances;   // [spectrum][wavelength], from 0 to kMostReflectance
};

// Above 1 by the error of a measurement; what is beyond is percent.
inline constexpr double kMostReflectance = 1.5;

// [wavelength] of one spectrum.
std::span<const double> spectrumAt(const MeasuredSpectra& spectra, std::size_t index);

// One spectrum on the model's grid: linear between the measured wavelengths, of which there are at
// least two, and beyond them.
Spectrum onGrid(const MeasuredSpectra& spectra, std::size_t index);

// Some of the spectra, in the order given.
MeasuredSpectra selected(const MeasuredSpectra& spectra, std::span<const std::size_t> indices);

// What lies outside the range must be numbers, too, but is left out. Errors name line and column:
// of cells that are no finite number, of negative or too large ones within the range, of rows that
// are too short or too long, of wavelengths that do not increase or of which fewer than `fewest`
// lie within the range. `place` stands in front.
Result<MeasuredSpectra> parseMeasuredSpectra(std::string_view text, const std::string& place,
                                             const WavelengthRange& range, std::size_t fewest,
                                             const JobContext& context);
// Files up to 1 GiB.
Result<MeasuredSpectra> readMeasuredSpectra(const std::filesystem::path& path,
                                            const WavelengthRange& range, std::size_t fewest,
                                            const JobContext& context);

}  // namespace cutis
