#pragma once  // internal to ui/color

// Numbers for the ends and the middle of a colour bar.

#include <array>

#include <QString>

#include "ui/color/display_range.h"

namespace cutis {

// In the user's locale, with the fewest decimals that are right to half a percent of the range, or
// of a logarithmic one to two percent of its lower end.
std::array<QString, 3> rangeTexts(const DisplayRange& range);

}  // namespace cutis
