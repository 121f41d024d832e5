#pragma once

class QWidget;

namespace cutis {

// What Cutis is, its version and its licence, in a dialog before the window. Returns when that is
// closed.
void showAbout(QWidget& window);

}  // namespace cutis
