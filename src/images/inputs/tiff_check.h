#pragma once

// Whether a TIFF file is whole.
//
// OpenImageIO reads pixels that are compressed as JPEG through an interface of libtiff that fills
// what is missing with grey and says nothing; the directory says how long the file must be.

#include <filesystem>

#include "core/base/result.h"

namespace cutis {

// Compares where the first directory says that the strips or tiles lie (TIFF 6.0, §2 and §15;
// BigTIFF as well) with the length of the file. What else may be wrong with the directory is left
// to the decoder. Precondition: the file begins like a TIFF.
Status checkTiffExtent(const std::filesystem::path& path);

}  // namespace cutis
