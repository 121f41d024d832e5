#pragma once

// Round numbers for axes and colour bars. Digits follow the span of the axis, not the value.

#include <array>
#include <vector>

#include <QString>

namespace cutis {

// 1, 2 or 5 times a power of ten, such that `span` has at most `most` steps. 1 for spans that are
// not positive and finite.
double niceStep(double span, int most);

// The smallest multiple of a nice step that is not below `value`; for the upper end of an axis.
double niceCeiling(double value, int most);

// Multiples of `step` within [minimum, maximum].
std::vector<double> ticksWithin(double minimum, double maximum, double step);

// 1, 2 and 5 times powers of ten within [minimum, maximum], for logarithmic axes; powers of ten
// alone where that would be more than `most`. None for ranges that are not positive and finite.
std::vector<double> logarithmicTicks(double minimum, double maximum, int most);

// In the user's locale, as many decimals as tell neighbours a `step` apart.
QString tickText(double value, double step);

// The ends and the middle of a range with the fewest decimals that are right to half a percent of
// it.
std::array<QString, 3> rangeTexts(double minimum, double maximum);

}  // namespace cutis
