#pragma once

// A picture's file before its format is asked: is it there, what kind is it, what does it contain.

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/images/codec/image_formats.h"

namespace cutis {

// The kind of a file by its first bytes and not by its name (except Targa, which has no mark of its
// own). Fails with a sentence for what is missing, a folder, no plain file, unreadable, empty, an
// undeveloped raw photograph or no picture of a format of the table.
Result<ImageFileKind> identifyImageFile(const std::filesystem::path& path);

// ContentHash of the bytes of a file.
Result<std::string> hashFile(const std::filesystem::path& path, const JobContext& context);

}  // namespace cutis
