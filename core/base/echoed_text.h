#pragma once

// What somebody wrote, as it stands in a sentence about it.
//
// Pure functions.

#include <string>
#include <string_view>

namespace cutis {

// Line breaks and other control characters become blanks.
std::string onOneLine(std::string text);

// At most 80 characters of the text, on one line; an ellipsis stands for what is left out of the
// middle. Bytes that are no UTF-8 stay.
std::string shortened(std::string_view text);

// The same of a place, "folder/file:line": what is behind its last slash stays whole up to 70
// characters, so that the file can be recognised.
std::string shortenedPlace(std::string_view place);

// At most 80 characters of a text in quotation marks: 'text'.
std::string inQuotes(std::string_view text);

}  // namespace cutis
