#pragma once  // internal to src/files/spectra

// Whether what stands above some spectra speaks of light that is emitted, and not of reflectance.

#include <optional>
#include <string>
#include <string_view>

namespace cutis {

struct EmissionWord {
  std::string word;  // "irradiance", "W/m²"
  int line = 0;
};

// The first word or unit of radiometry or photometry in the lines before `endLine`, counted from 1.
// Lines that speak of reflectance or of a factor (radiance factor) do not count.
std::optional<EmissionWord> emissionWordAbove(std::string_view text, int endLine);

}  // namespace cutis
