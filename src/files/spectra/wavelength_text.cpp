#include "src/files/spectra/wavelength_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"

namespace cutis {
namespace {

// A product with 1000 is a wavelength in nm again.
constexpr int kWavelengthDigits = 12;

using UnitName = std::pair<std::string_view, WavelengthUnit>;

// Lower case, the longer of two that end alike first; µ and Å in UTF-8 (two signs each) and in
// Latin-1.
constexpr auto kUnitNames = std::to_array<UnitName>({
    {"nanometers", WavelengthUnit::nanometres},
    {"nanometres", WavelengthUnit::nanometres},
    {"nanometer", WavelengthUnit::nanometres},
    {"nanometre", WavelengthUnit::nanometres},
    {"nm", WavelengthUnit::nanometres},
    {"micrometers", WavelengthUnit::micrometres},
    {"micrometres", WavelengthUnit::micrometres},
    {"micrometer", WavelengthUnit::micrometres},
    {"micrometre", WavelengthUnit::micrometres},
    {"microns", WavelengthUnit::micrometres},
    {"micron", WavelengthUnit::micrometres},
    {"um", WavelengthUnit::micrometres},
    {"\xC2\xB5m", WavelengthUnit::micrometres},
    {"\xCE\xBCm", WavelengthUnit::micrometres},
    {"\xB5m", WavelengthUnit::micrometres},
    {"angstroms", WavelengthUnit::angstroms},
    {"angstrom", WavelengthUnit::angstroms},
    {"\xC3\xA5ngstr\xC3\xB6m", WavelengthUnit::angstroms},
    {"\xC3\x85ngstr\xC3\xB6m", WavelengthUnit::angstroms},
    {"\xC3\x85", WavelengthUnit::angstroms},
    {"\xE2\x84\xAB", WavelengthUnit::angstroms},
    {"\xC5", WavelengthUnit::angstroms},
    {"cm-1", WavelengthUnit::wavenumbers},
    {"cm^-1", WavelengthUnit::wavenumbers},
    {"1/cm", WavelengthUnit::wavenumbers},
    {"cm\xE2\x81\xBB\xC2\xB9", WavelengthUnit::wavenumbers},
    {"wavenumber", WavelengthUnit::wavenumbers},
    {"wavenumbers", WavelengthUnit::wavenumbers},
});

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 ||
         (static_cast<unsigned char>(c) & 0x80) != 0;
}

std::string_view withoutBrackets(std::string_view text) {
  constexpr std::string_view kEdges = " \t[](){}_,;:/";
  const auto first = text.find_first_not_of(kEdges);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kEdges) - first + 1);
}

std::optional<WavelengthUnit> unitNamed(std::string_view word) {
  for (const auto& [name, unit] : kUnitNames) {
    if (word == name) return unit;
  }
  return std::nullopt;
}

// A unit at the end of a cell, which is taken off.
std::optional<WavelengthUnit> takeUnit(std::string_view& lower) {
  const std::string_view content = withoutBrackets(lower);
  for (const auto& [name, unit] : kUnitNames) {
    if (!content.ends_with(name) || content.size() == name.size()) continue;
    const char before = content[content.size() - name.size() - 1];
    if (isLetter(before)) continue;
    lower = content.substr(0, content.size() - name.size());
    constexpr std::string_view kBetween = " \t[(_";
    const auto last = lower.find_last_not_of(kBetween);
    lower = last == std::string_view::npos ? std::string_view() : lower.substr(0, last + 1);
    return unit;
  }
  return std::nullopt;
}

double inNanometres(double value, WavelengthUnit unit) {
  switch (unit) {
    case WavelengthUnit::micrometres:
      return roundedTo(value * 1000.0, kWavelengthDigits);
    case WavelengthUnit::angstroms:
      return value / 10.0;
    case WavelengthUnit::nanometres:
    case WavelengthUnit::wavenumbers:
      return value;
  }
  return value;
}

// The number at the end of a label whose words say that it is a wavelength.
std::string_view numberOfLabel(std::string_view lower) {
  constexpr std::array<std::string_view, 14> kLabels = {
      "spectral", "spectralnm",  "spectraldata", "spec", "nm",   "r",      "x",
      "wl",       "reflectance", "wavelength",   "refl", "wave", "lambda", "specnm"};
  const auto end = lower.find_last_not_of("0123456789.,");
  if (end == std::string_view::npos) return lower;
  std::string words;
  for (const char c : lower.substr(0, end + 1)) {
    if (isLetter(c)) {
      words += c;
    } else if (c != ' ' && c != '_' && c != '-' && c != ':' && c != '.') {
      return {};
    }
  }
  if (std::find(kLabels.begin(), kLabels.end(), words) == kLabels.end()) return {};
  return lower.substr(end + 1);
}

}  // namespace

std::string loweredText(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

std::optional<double> wavelengthOf(std::string_view field, const WavelengthFormat& format) {
  const auto finite = [](std::optional<double> number, WavelengthUnit unit) {
    if (!number || !std::isfinite(*number)) return std::optional<double>();
    return std::optional(inNanometres(*number, unit));
  };
  if (const auto number = format.numbers.parse(field)) return finite(number, format.unit);
  if (field.empty()) return std::nullopt;
  const std::string lower = loweredText(withoutBlanks(field));
  std::string_view rest = lower;
  const auto own = takeUnit(rest);
  if (format.labelled) rest = numberOfLabel(rest);
  if (!own && !format.labelled) return std::nullopt;
  return finite(format.numbers.parse(rest), own.value_or(format.unit));
}

bool looksLikeWavelength(std::string_view field, const WavelengthFormat& format) {
  return wavelengthOf(field, format).value_or(0.0) >= kLeastWavelengthNm;
}

bool isWavelengthHeading(std::string_view field) {
  const std::string name = loweredText(field);
  for (const std::string_view start :
       {"wave", "lambda", "\xCE\xBB", "nm", "wellenl", "longueur d", "longitud de o"}) {
    if (name.starts_with(start)) return true;
  }
  const std::string_view bare = withoutBrackets(name);
  return bare == "wl" || name.starts_with("wl ") || name.starts_with("wl_") ||
         name.starts_with("wl(") || unitNamed(bare).has_value();
}

bool isIdentifierHeading(std::string_view field) {
  constexpr std::array<std::string_view, 6> kNames = {"id",      "name",   "sample",
                                                      "subject", "record", "label"};
  return std::find(kNames.begin(), kNames.end(), loweredText(field)) != kNames.end();
}

bool isUnitOnly(std::string_view field) {
  const std::string lower = loweredText(withoutBlanks(field));
  if (lower.size() >= 2 && lower.front() == '[' && lower.back() == ']') return true;
  const std::string_view bare = withoutBrackets(lower);
  return bare == "%" || bare == "counts" || bare == "a.u." || unitNamed(bare).has_value();
}

bool saysCounts(std::string_view field) {
  const std::string lower = loweredText(withoutBlanks(field));
  return lower.ends_with("[counts]") || lower.ends_with("(counts)") || lower == "counts";
}

std::optional<WavelengthUnit> unitOf(std::string_view heading) {
  const std::string lower = loweredText(heading);
  if (lower.ends_with("(a)") || lower.ends_with("[a]")) return WavelengthUnit::angstroms;
  if (const auto unit = unitNamed(withoutBrackets(lower))) return unit;
  std::string_view rest = lower;
  if (const auto unit = takeUnit(rest)) return unit;
  if (lower.starts_with("wavenumber")) return WavelengthUnit::wavenumbers;
  // In the middle, as in "Wavelength / nm (air)".
  std::size_t i = 0;
  while (i < lower.size()) {
    std::size_t end = i;
    while (end < lower.size() && isLetter(lower[end]))
      ++end;
    if (const auto unit = unitNamed(std::string_view(lower).substr(i, end - i))) return unit;
    i = end + 1;
  }
  return std::nullopt;
}

}  // namespace cutis
