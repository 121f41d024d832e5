#pragma once  // internal to src/files/spectra

// The tables of CGATS.17 and its kin (i1Profiler, ProfileMaker, Argyll): keywords, a format of
// named fields, and sets of values between BEGIN_DATA and END_DATA, all separated by blanks.

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "src/files/io/csv.h"

namespace cutis {

bool isCgats(std::string_view text);

// The first table whose fields have spectra: its names as the header, a row per set. `tables` is
// how many of them there are. Errors name the line: of sets that are incomplete, and of files
// without spectra. `place` stands in front.
struct CgatsTable {
  CsvTable source;  // which the table refers to
  CsvTable table;
  std::size_t tables = 0;
};
Result<CgatsTable> splitCgats(std::string_view text, const std::string& place);

}  // namespace cutis
