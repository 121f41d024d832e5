#pragma once

// Words and settings of OpenImageIO. For the files of this folder.

#include <string>

#include <OpenImageIO/typedesc.h>

#include "core/base/result.h"
#include "src/images/codec/sample_type.h"

namespace cutis {

// The first line of a message, without the file's name and not too long.
std::string oiioReason(const std::string& message, const std::string& place);

// What a message of the library says of a file that it could not read: that memory is missing, that
// the file uses what the library does not know, or else that it is damaged.
Error readingError(const std::string& message, const std::string& format, const std::string& place);

OIIO::TypeDesc oiioType(SampleType type);

// Limits that hold for the whole program; called before anything is opened. Thread-safe.
void setUpOpenImageIO();

}  // namespace cutis
