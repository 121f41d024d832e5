#pragma once

// Asks the user for the name of a file that is to be written. Interface thread only.

#include <QString>

class QWidget;

namespace cutis {

class Document;

// Shows a dialog that begins with `path`. Filters are in Qt's notation, "OpenEXR (*.exr);;…"; a
// name without an extension is given the first of the filter that was chosen. Empty if the user
// cancels.
QString chooseFileToWrite(QWidget* parent, const QString& title, const QString& path,
                          const QString& filters);

// The extension that a filter stands for, without its dot: "tif" for "TIFF (*.tif *.tiff)". Empty
// if it stands for any.
QString extensionOf(const QString& filter);

// `name` in the folder that the document was opened from; `name` alone for the sample and while
// nothing is open.
QString besideSource(const Document& document, const QString& name);

}  // namespace cutis
