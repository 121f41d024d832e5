#pragma once  // internal to ui/view

// Numbers for the ends and the middle of a colour bar.

#include <array>

#include <QString>

namespace cutis {

// In the user's locale, with the fewest decimals that are right to half a percent of the range.
std::array<QString, 3> rangeTexts(double minimum, double maximum);

}  // namespace cutis
