#pragma once  // internal to ui/spectrum

// What the foot of the window says of the pixel under the cursor.

#include <optional>

#include <QPoint>
#include <QString>

#include "src/app/document/document.h"

namespace cutis {

// "492, 492   Melanin 6.4 %, edited 9.6 %   Melanin blend 70 %  …", or that there is no estimate,
// or that it is one of a fit that was cancelled.
// deviation: of the values that were found, where it is known: "Melanin 6.4 % ± 0.8 %".
QString pixelReadout(const Document& document, const QPoint& pixel,
                     const std::optional<ParameterVector>& deviation = std::nullopt);

}  // namespace cutis
