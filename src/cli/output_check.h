#pragma once

// Outputs looked at before any work is done: writable, and never a file that is read.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "src/app/export/overwrite_protection.h"

namespace cutis {

// A usage error if two results of one command are one file.
Status checkDistinct(const std::string& output, const std::string& other);

// A text, of whatever extension, could be written and is none of the inputs.
Status checkTextOutput(const std::string& output, const std::vector<std::string>& inputs);

// The folder of a capture could be written: it is new or empty, or a capture that may be replaced.
Status checkCaptureFolder(const std::string& output, bool overwrite);

}  // namespace cutis
