#pragma once

// Colours of pinned places: the same for a place's marker in the picture and for its curve. Beside
// them stands the place's letter, never colour alone.

#include "src/report/drawing.h"

namespace cutis {

// They differ in hue and in lightness, for readers who do not distinguish all hues, and come again
// after the last. number: of the letter, from 0. For dark grounds and for paper.
Color pinColor(int number);
Color printedPinColor(int number);

}  // namespace cutis
