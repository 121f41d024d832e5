#pragma once

// Drawings as files: SVG, or PNG with twice as many pixels as the drawing has, for dense screens.
//
// PNG takes a font that the program carries, so that it looks the same on every machine; SVG names
// fonts and leaves it to the viewer. PNG is drawn by a part of the program that is loaded when it
// is first needed, from the folder of the program.

#include <filesystem>

#include "core/base/result.h"
#include "src/report/drawing.h"

namespace cutis {

// Whether writeDrawing() could succeed, found out before the work that leads up to it is done. A
// usage error if the name ends in neither .svg nor .png.
Status checkDrawingOutput(const std::filesystem::path& path);

// Errors: as above; no room to write to. PNG: from one thread at a time.
Status writeDrawing(const std::filesystem::path& path, const Drawing& drawing);

}  // namespace cutis
