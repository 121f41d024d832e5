#pragma once

// A picture's file before its format is asked: is it there, what kind is it, what does it contain.

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"

namespace cutis {

// The formats that are read, told by their first bytes and not by the file's name (except Targa,
// which has no mark of its own).
enum class ImageFileKind { png, tiff, openExr, jpeg, bmp, radiance, targa };

// "PNG", "OpenEXR", …
std::string imageKindName(ImageFileKind kind);

// Fails with a sentence for what is missing, a folder, no plain file, unreadable, empty, an
// undeveloped raw photograph or no picture of a kind above.
Result<ImageFileKind> identifyImageFile(const std::filesystem::path& path);

// ContentHash of the bytes of a file.
Result<std::string> hashFile(const std::filesystem::path& path, const JobContext& context);

}  // namespace cutis
