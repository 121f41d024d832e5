#pragma once  // internal to src/report

// A drawing as SVG.

#include <string>
#include <string_view>

#include "src/report/drawing.h"

namespace cutis {

// family: of the font, as in CSS. Well-formed whatever the words are; places to a tenth of a pixel.
std::string svgOf(const Drawing& drawing, std::string_view family);

}  // namespace cutis
