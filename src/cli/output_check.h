#pragma once

// Outputs looked at before any work is done: known format, writable, and never a file that is read.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "src/images/codec/sample_type.h"

namespace cutis {

// Every file a path stands for: a capture's manifest, photographs and mask, or the path itself.
// Fails if a capture.json cannot be read.
Result<std::vector<std::string>> inputFiles(const std::string& path);

// A usage error if the output is one of the inputs, under whatever name. Empty names are passed
// over.
Status checkNotInput(const std::string& output, const std::vector<std::string>& inputs);
// The same between the outputs of one command.
Status checkDistinct(const std::string& output, const std::string& other);

// The output is OpenEXR and could be written.
Status checkMapsOutput(const std::string& output, const std::vector<std::string>& inputs);
// A text, of whatever extension.
Status checkTextOutput(const std::string& output, const std::vector<std::string>& inputs);

// The folder of a capture could be written: it is new, empty or a capture already.
Status checkCaptureFolder(const std::string& output);

// What --bit-depth asks for, "half", "float", "8" or "16", else the most usual of the format;
// checked to be writable.
Result<SampleType> imageOutputType(const std::string& output, const std::string& bitDepth,
                                   const std::vector<std::string>& inputs);

}  // namespace cutis
