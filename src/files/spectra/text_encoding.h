#pragma once  // internal to src/files/spectra

// What a file's bytes say as text, whatever program wrote them.

#include <string>

#include "core/base/result.h"

namespace cutis {

struct DecodedText {
  std::string text;        // UTF-8
  bool isGuessed = false;  // was no UTF-8 and was read as Windows-1252
};

// UTF-8 with or without a byte order mark stays as it is. UTF-16 of either byte order, with a mark
// or recognised by the zeros between its letters, becomes UTF-8. What is neither is read as
// Windows-1252, of which Latin-1 is a part. Fails for what is no text, and says what it is. `place`
// stands in front. Pure.
Result<DecodedText> decodedText(std::string bytes, const std::string& place);

}  // namespace cutis
