#pragma once

// What people read of the five parameters. Interface thread only.

#include <QString>

#include "core/skin/profile/parameter.h"

namespace cutis {

// "Dermal haemoglobin"
QString parameterTitle(Parameter parameter);
// "volume fraction", "g/L"
QString parameterUnitText(Parameter parameter);
// Both haemoglobins as one.
QString haemoglobinTitle();

}  // namespace cutis
