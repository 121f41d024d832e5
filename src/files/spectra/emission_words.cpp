#include "src/files/spectra/emission_words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "src/files/spectra/wavelength_text.h"

namespace cutis {
namespace {

// In lower case.
constexpr std::array<std::string_view, 12> kWords = {
    "irradiance", "illuminance", "radiance", "luminance", "radiant", "spectral power",
    "w/m2",       "w/m^2",       "w/m²",     "w/(m",      "w/cm",    "w/sr"};
constexpr std::array<std::string_view, 3> kOfReflectance = {"reflect", "factor", "transmi"};

bool hasOneOf(std::string_view line, std::span<const std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
    return line.find(word) != std::string_view::npos;
  });
}

}  // namespace

std::optional<EmissionWord> emissionWordAbove(std::string_view text, int endLine) {
  for (int line = 1; line < endLine && !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string lower = loweredText(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (hasOneOf(lower, kOfReflectance)) continue;
    for (const std::string_view word : kWords) {
      if (lower.find(word) != std::string::npos) return EmissionWord{std::string(word), line};
    }
  }
  return std::nullopt;
}

}  // namespace cutis
