#pragma once

// Round numbers for axes. Digits follow the span of the axis, not the value.

#include <string>
#include <utility>
#include <vector>

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

// The nearest 1, 2 or 5 times powers of ten that have both values between them, or powers of ten
// alone; the second end is above the first. Precondition: 0 < minimum ≤ maximum, finite.
std::pair<double, double> roundEnds(double minimum, double maximum);
std::pair<double, double> decadeEnds(double minimum, double maximum);

// Decimals that tell neighbours a `step` apart, 0 to 9.
int decimalsFor(double step);
// As many decimals as that, whatever the locale, with the sign of a minus.
std::string tickWords(double value, double step);

}  // namespace cutis
