#pragma once

// What Cutis keeps of the faces that were worked on, outside of people's own files.

class QWidget;

namespace cutis {

// Removes journals that no running Cutis holds, everything in the cache, and the names of recent
// files and folders. Projects and pictures stay.
void clearPrivateData();
// Asks first; the question stands before the window.
void askToClearPrivateData(QWidget& window);

}  // namespace cutis
