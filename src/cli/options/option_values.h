#pragma once

// The values that the texts of options stand for. Errors are usage errors in the option's name.
// Numbers do not depend on the locale.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/skin/profile/parameter.h"
#include "src/images/codec/sample_type.h"

namespace cutis {

// A number within [least, most].
Result<double> realNumber(const std::string& option, const std::string& text, double least,
                          double most);
Result<int> wholeNumber(const std::string& option, const std::string& text, int least, int most);
Result<std::uint64_t> seedNumber(const std::string& option, const std::string& text);

// "a,b,c" → fields without blanks around them; none for an empty text.
std::vector<std::string> commaSeparated(const std::string& text);
// As many numbers as asked for, each within [least, most].
Result<std::vector<double>> realNumbers(const std::string& option, const std::string& text,
                                        std::size_t count, double least, double most);

// "half", "float", "8" or "16"; nothing for an empty text.
Result<std::optional<SampleType>> bitDepth(const std::string& option, const std::string& text);

struct PixelSize {
  int width = 0;
  int height = 0;
};
// "1024x768"
Result<PixelSize> pixelSize(const std::string& option, const std::string& text, int most);

struct Assignment {
  Parameter parameter = kMelanin;
  double value = 0.0;
};
// "carotene=0.002"
Result<Assignment> assignment(const std::string& option, const std::string& text);

}  // namespace cutis
