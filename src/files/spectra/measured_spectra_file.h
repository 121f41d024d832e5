#pragma once

// Measured reflectance spectra as instruments and spreadsheets write them.
//
// Comma-, semicolon- or tab-separated values (RFC 4180), columns set by blanks, or CGATS; UTF-8 or
// UTF-16, else Windows-1252, with a notice; decimal points or commas. One spectrum a row or one a
// column, at any distances, from short to long wavelengths or back. Wavelengths are in nm, or in
// the unit that a heading names (µm, Å); they stand in the first row or in the first column,
// whichever reads as wavelengths (numbers from 100, "380 nm", "Spectral Data 380[nm]"); where both
// do, in the row, unless the first field says "wavelength" or "nm". Text that instruments write
// above or below is passed over.
//
// A row's leading columns whose heading is no number name the spectrum: the one called id, name,
// sample, subject, record or label, else the first. In columns the heading holds the names. Spectra
// without a name are numbered from 1. Comments, quotes and line ends are as in src/files/io/csv.h.
//
// Values are shares of the perfect diffuser, or percent where a heading, a unit or a line above
// declares it, else where most are above kMostReflectance; a notice says which. Notices say, too,
// what of a file was left out, and question files whose heading speaks of emitted light.

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/spectra/measured_spectra.h"

namespace cutis {

// What lies outside the range does not matter. Errors name line and column: of cells within the
// range that are no finite number, negative or too large, of rows that are too short or too long,
// of wavelengths that appear twice or are not sorted, or of which fewer than `fewest` lie within
// the range. `place` stands in front.
Result<MeasuredSpectra> parseMeasuredSpectra(std::string_view text, const std::string& place,
                                             const WavelengthRange& range, std::size_t fewest,
                                             const JobContext& context);
// Files up to 1 GiB.
Result<MeasuredSpectra> readMeasuredSpectra(const std::filesystem::path& path,
                                            const WavelengthRange& range, std::size_t fewest,
                                            const JobContext& context);

}  // namespace cutis
