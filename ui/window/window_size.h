#pragma once  // internal to ui/window

// How large a window may be on a screen. Sizes in device-independent pixels.

#include <QRect>

namespace cutis {

// The rectangle that comes nearest to `wanted`, which is without the frame, so that window and
// frame lie within what the screen has free.
QRect withinScreen(const QRect& wanted, const QRect& available);

}  // namespace cutis
