#pragma once

// What file dialogs offer of src/images/codec/image_formats.h, in Qt's notation.

#include <QString>

namespace cutis {

// All that can be read, "*.exr *.tif *.tiff …".
QString readableImagePatterns();

// What can be written, a filter a format: "OpenEXR (*.exr);;TIFF (*.tif *.tiff);;…".
QString writableImageFilters();

}  // namespace cutis
