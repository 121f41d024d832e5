#pragma once

// Drawings as what other programs take: pages of PDF, and pictures for the clipboard. With the
// fonts of the machine, which PDF brings along.

#include <QByteArray>
#include <QImage>

#include "src/report/drawing.h"

namespace cutis {

// One page as large as the drawing, at 96 pixels per inch. Empty where it cannot be made. Any
// thread, while the program has its QGuiApplication.
QByteArray pdfOf(const Drawing& drawing);
// scale: pixels per unit of the drawing.
QImage imageOf(const Drawing& drawing, double scale);

}  // namespace cutis
