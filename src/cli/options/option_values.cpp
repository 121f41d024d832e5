#include "src/cli/options/option_values.h"

#include <charconv>
#include <cmath>

#include "core/base/echoed_text.h"
#include "core/base/number_text.h"
#include "core/skin/profile/parameter_names.h"
#include "src/files/io/suggestion.h"

namespace cutis {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string rangeText(double least, double most) {
  return formatNumber(least) + " to " + formatNumber(most);
}

template <typename Integer>
bool parseWhole(const std::string& text, Integer& value) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

}  // namespace

Result<double> realNumber(const std::string& option, const std::string& text, double least,
                          double most) {
  const auto number = parseNumber(text);
  if (!number || !std::isfinite(*number)) {
    return usageError(option,
                      inQuotes(text) + " is not a number; give one from " + rangeText(least, most));
  }
  if (*number < least || *number > most) {
    return usageError(option, formatNumber(*number) + " is out of range; give a number from " +
                                  rangeText(least, most));
  }
  return *number;
}

Result<int> wholeNumber(const std::string& option, const std::string& text, int least, int most) {
  int number = 0;
  if (!parseWhole(text, number) || number < least || number > most) {
    return usageError(option, inQuotes(text) + " is not a whole number from " +
                                  std::to_string(least) + " to " + std::to_string(most));
  }
  return number;
}

Result<std::uint64_t> seedNumber(const std::string& option, const std::string& text) {
  std::uint64_t number = 0;
  if (!parseWhole(text, number)) {
    return usageError(option, inQuotes(text) + " is not a whole number of at most 64 bits");
  }
  return number;
}

std::vector<std::string> commaSeparated(const std::string& text) {
  std::vector<std::string> fields;
  if (trimmed(text).empty()) return fields;
  std::size_t begin = 0;
  for (;;) {
    const auto comma = text.find(',', begin);
    fields.push_back(trimmed(text.substr(begin, comma - begin)));
    if (comma == std::string::npos) return fields;
    begin = comma + 1;
  }
}

Result<std::vector<double>> realNumbers(const std::string& option, const std::string& text,
                                        std::size_t count, double least, double most) {
  const std::vector<std::string> fields = commaSeparated(text);
  if (fields.size() != count) {
    return usageError(option, inQuotes(text) + " must be " + std::to_string(count) +
                                  " numbers, separated by commas");
  }
  std::vector<double> numbers;
  for (const std::string& field : fields) {
    CUTIS_TRY(number, realNumber(option, field, least, most));
    numbers.push_back(number);
  }
  return numbers;
}

Result<std::optional<SampleType>> bitDepth(const std::string& option, const std::string& text) {
  if (text.empty()) return std::optional<SampleType>();
  for (const auto& [name, type] :
       {std::pair{"half", SampleType::half}, std::pair{"float", SampleType::float32},
        std::pair{"8", SampleType::uint8}, std::pair{"16", SampleType::uint16}}) {
    if (text == name) return std::optional(type);
  }
  return usageError(option, "'" + text + "' is unknown; choose half, float, 8 or 16");
}

Result<PixelSize> pixelSize(const std::string& option, const std::string& text, int most) {
  const auto cross = text.find('x');
  PixelSize size;
  const bool read = cross != std::string::npos && parseWhole(text.substr(0, cross), size.width) &&
                    parseWhole(text.substr(cross + 1), size.height);
  const auto fits = [&](int side) { return side >= 1 && side <= most; };
  if (read && fits(size.width) && fits(size.height)) return size;
  return usageError(option, inQuotes(text) +
                                " is not a size in pixels; write WIDTHxHEIGHT, each from "
                                "1 to " +
                                std::to_string(most));
}

Result<Assignment> assignment(const std::string& option, const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) {
    return usageError(option, inQuotes(text) + " must be NAME=VALUE, such as carotene=0");
  }
  const std::string name = trimmed(text.substr(0, equals));
  const auto parameter = parameterByName(name);
  if (!parameter) {
    const auto names = parameterNames();
    return usageError(option, "unknown parameter " + inQuotes(name) + "; " +
                                  suggestName(name, {names.begin(), names.end()}));
  }
  const auto value = parseNumber(trimmed(text.substr(equals + 1)));
  if (!value || !std::isfinite(*value)) {
    return usageError(option, inQuotes(text) + " has no number; write " + name + "=VALUE");
  }
  return Assignment{*parameter, *value};
}

}  // namespace cutis
