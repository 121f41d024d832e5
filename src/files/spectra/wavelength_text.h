#pragma once  // internal to src/files/spectra

// Wavelengths as tables and instruments write them, and the words that stand above them.

#include <optional>
#include <string>
#include <string_view>

#include "src/files/spectra/number_format.h"

namespace cutis {

enum class WavelengthUnit { nanometres, micrometres, angstroms, wavenumbers };

// Less is an ordinal number, or a wavelength in another unit than the one assumed.
inline constexpr double kLeastWavelengthNm = 100.0;

// How cells are read: numbers in the unit of the heading; with a unit of their own; labelled, such
// as "Spectral Data 380[nm]" or "SPECTRAL_NM380".
struct WavelengthFormat {
  NumberFormat numbers;
  WavelengthUnit unit = WavelengthUnit::nanometres;
  bool labelled = false;
};

// In nm; nothing for text that is no wavelength, and for what is not finite.
std::optional<double> wavelengthOf(std::string_view field, const WavelengthFormat& format);
bool looksLikeWavelength(std::string_view field, const WavelengthFormat& format);

// "wavelength_nm", "Wave", "[nm]"
bool isWavelengthHeading(std::string_view field);
// "id", "name", …
bool isIdentifierHeading(std::string_view field);
// "[counts]", "%", "nm": what stands below a heading.
bool isUnitOnly(std::string_view field);
// Raw readings of a detector, by their unit.
bool saysCounts(std::string_view field);

// The unit in a heading: "Wavelength (µm)", "wavelength_um", "[nm]"; nothing if it names none.
std::optional<WavelengthUnit> unitOf(std::string_view heading);

std::string loweredText(std::string_view text);

}  // namespace cutis
