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
#include <string>
#include <string_view>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/spectra/measured_spectra.h"

namespace cutis {

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
