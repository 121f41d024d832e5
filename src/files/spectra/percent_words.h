#pragma once  // internal to src/files/spectra

// Whether the words around some spectra declare that their values are percent.

#include <optional>
#include <string_view>

namespace cutis {

// Whether a heading or a unit says so: "%R", "s [%]", "percent"; not "50 % grey", which counts
// something else.
bool declaresPercent(std::string_view heading);

// The first line before `endLine`, counted from 1, that declares it of the values: "# Reflectance
// in %", "Unit: %".
std::optional<int> percentLineAbove(std::string_view text, int endLine);

}  // namespace cutis
