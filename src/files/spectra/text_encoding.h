#pragma once  // internal to src/files/spectra

// What a file's bytes say as text, whatever program wrote them.

#include <string>

#include "core/base/result.h"

namespace cutis {

// UTF-8 with or without a byte order mark stays as it is, and so do the one-byte encodings, whose
// letters beyond ASCII are not told apart. UTF-16 of either byte order, with a mark or recognised
// by the zeros between its letters, becomes UTF-8. Fails for what is no text, and says what it is.
// `place` stands in front. Pure.
Result<std::string> decodedText(std::string bytes, const std::string& place);

}  // namespace cutis
