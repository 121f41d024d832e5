#pragma once

// Numbers as text and back, independent of the locale: in files, in tables for people, in messages.
//
// Pure functions.

#include <optional>
#include <string>
#include <string_view>

namespace cutis {

// Nothing for text that is not wholly a number. Takes a leading plus sign, no blanks.
std::optional<double> parseNumber(std::string_view text);

// `digits` significant digits, 1 to 17, without trailing zeros; "nan", "inf" or "-inf".
std::string formatNumber(double value, int digits = 9);

// Fixed decimals, up to 30; "-" for what is not finite.
std::string fixedNumber(double value, int decimals);

// "3.82e-6": two decimals and no zeros in the exponent; "0" for zero, "-" for what is not finite.
std::string shortScientific(double value);

// "100 %", "0.52 %", "12 %": a share as people write it, with `digits` significant digits where it
// has decimals, never with an exponent, and "100 %" only for all; "-" for what is not finite.
std::string percentText(double share, int digits);

// The number that formatNumber(value, digits) reads back as.
double roundedTo(double value, int digits);

}  // namespace cutis
