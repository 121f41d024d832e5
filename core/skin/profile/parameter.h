#pragma once

// The five numbers that describe the skin of one pixel, in the order used everywhere: files,
// options, planes. What is said of each is a row of core/skin/profile/chromophore_table.h. Where
// five is frozen a static_assert on kParameterCount names what a sixth needs there.

#include <array>
#include <optional>
#include <string_view>

namespace cutis {

enum Parameter : int {
  kMelanin = 0,           // C_m: volume fraction of melanosomes in the epidermis
  kMelaninBlend,          // β_m: share of eumelanin, the rest is pheomelanin
  kHaemoglobinDermal,     // C_hd: volume fraction of whole blood in the dermis
  kHaemoglobinEpidermal,  // C_he: volume fraction of whole blood in the epidermis
  kCarotene,              // C_bc: β-carotene in the epidermis, g/L
};
inline constexpr int kParameterCount = 5;

inline constexpr std::array<Parameter, kParameterCount> kParameters = {
    kMelanin, kMelaninBlend, kHaemoglobinDermal, kHaemoglobinEpidermal, kCarotene};

// "melanin", "melanin_blend", … as they stand in files.
std::string_view parameterName(Parameter parameter);
// "C_m", "β_m", …
std::string_view parameterSymbol(Parameter parameter);
// "volume fraction", "g/L", …
std::string_view parameterUnit(Parameter parameter);
std::optional<Parameter> parameterByName(std::string_view name);

}  // namespace cutis
