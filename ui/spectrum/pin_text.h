#pragma once  // internal to ui/spectrum

// What is known of pins as a table for spreadsheets.

#include <string>
#include <vector>

#include "src/app/document/pin_readings.h"

namespace cutis {

// A header and a row per pin: place, pixels, then the parameters with their deviations and the
// indices, of the original skin and, behind each, of the edited. Seven significant digits, decimal
// points; what is not known is empty.
std::string pinsText(const std::vector<PinReading>& readings, const PinSet& set, char separator);

}  // namespace cutis
