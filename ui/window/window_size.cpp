#include "ui/window/window_size.h"

#include <algorithm>

#include <QMargins>

namespace cutis {
namespace {

// The window manager's frame; before a window is shown nobody knows its true one.
constexpr QMargins kWindowFrame(8, 36, 8, 8);

}  // namespace

QRect withinScreen(const QRect& wanted, const QRect& available) {
  const QRect room = available.marginsRemoved(kWindowFrame);
  QRect placed(wanted.topLeft(), wanted.size().boundedTo(room.size()));
  placed.moveLeft(std::clamp(placed.left(), room.left(), room.right() + 1 - placed.width()));
  placed.moveTop(std::clamp(placed.top(), room.top(), room.bottom() + 1 - placed.height()));
  return placed;
}

}  // namespace cutis
