#pragma once

// Asks the user for the name of a file that is to be written. Interface thread only.

#include <functional>

#include <QString>

class QWidget;

namespace cutis {

class Document;

// Why a file cannot be written, in one sentence; empty if it can.
using FileObjection = std::function<QString(const QString& path)>;

// Shows a dialog that begins with `path`. Filters are in Qt's notation, "OpenEXR (*.exr);;…"; a
// name without an extension is given the first of the filter that was chosen. Empty if the user
// cancels. A file that meets an objection is refused with it.
QString chooseFileToWrite(QWidget* parent, const QString& title, const QString& path,
                          const QString& filters, const FileObjection& objection = {});

// The extension that a filter stands for, without its dot: "tif" for "TIFF (*.tif *.tiff)". Empty
// if it stands for any.
QString extensionOf(const QString& filter);

// `name` in the folder that the document was opened from; `name` alone for the sample and while
// nothing is open.
QString besideSource(const Document& document, const QString& name);

// The same for what is made of the document: "face_maps.exr" for "face.png" and "maps.exr".
QString besideSourceNamedAfter(const Document& document, const QString& what);

// Files that the document was made of are never written.
QString objectionToWriting(const Document& document, const QString& path);

}  // namespace cutis
