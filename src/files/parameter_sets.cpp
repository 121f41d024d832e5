#include "src/files/parameter_sets.h"

#include <array>
#include <cmath>

#include "core/base/echoed_text.h"
#include "core/base/number_text.h"
#include "core/skin/profile/chromophore_table.h"
#include "core/skin/profile/parameter_names.h"
#include "src/files/io/csv.h"
#include "src/files/io/suggestion.h"
#include "src/files/io/text_file.h"

namespace cutis {
namespace {

constexpr std::size_t kLargestSetsFile = std::size_t{1} << 30;

using Columns = std::array<std::size_t, kParameterCount>;  // indexed by Parameter

std::vector<std::string> knownNames() {
  const auto names = parameterNames();
  return {names.begin(), names.end()};
}

Result<Columns> columnsOf(const CsvRow& header, const std::string& place) {
  Columns columns = {};
  std::array<bool, kParameterCount> found = {};
  for (std::size_t c = 0; c < header.fields.size(); ++c) {
    const auto parameter = parameterByName(header.fields[c]);
    if (!parameter) {
      return inputError(place, "unknown column " + inQuotes(std::string(header.fields[c])) + "; " +
                                   suggestName(std::string(header.fields[c]), knownNames()));
    }
    if (found[*parameter]) {
      return inputError(place,
                        "the column " + inQuotes(std::string(header.fields[c])) + " appears twice");
    }
    found[*parameter] = true;
    columns[*parameter] = c;
  }
  for (const Parameter parameter : kParameters) {
    if (!found[parameter]) {
      return inputError(
          place, "the column " + inQuotes(std::string(parameterName(parameter))) + " is missing");
    }
  }
  return columns;
}

}  // namespace

Result<ParameterVector> parseParameters(std::span<const std::string_view> fields,
                                        const ParameterAxes& axes, const std::string& place,
                                        ErrorKind kind) {
  if (fields.size() != kParameterCount) {
    return Error{kind, place,
                 "there are " + std::to_string(fields.size()) +
                     " values; give five: " + parameterNames(", ")};
  }
  ParameterVector values;
  for (const Parameter parameter : kParameters) {
    const std::string_view field = fields[parameter];
    const std::string name(parameterName(parameter));
    const auto number = parseNumber(field);
    if (!number || !std::isfinite(*number)) {
      return Error{kind, place,
                   name + " is " + inQuotes(std::string(field)) + ", which is not a number"};
    }
    const double most = axes[parameter].maximum;
    if (*number < 0.0 || *number > most) {
      return Error{kind, place,
                   name + " is " + formatNumber(*number) +
                       ", out of range; give a value from 0 to " + formatNumber(most)};
    }
    values[parameter] = *number;
  }
  return values;
}

Result<std::vector<ParameterVector>> readParameterSets(const std::string& path,
                                                       const ParameterAxes& axes) {
  CUTIS_TRY(text, readTextFile(path, kLargestSetsFile));
  const CsvTable rows = splitCsv(text);
  if (rows.empty()) return inputError(path, "the file has no rows; begin with a header");
  const auto placeOf = [&](const CsvRow& row) { return path + ":" + std::to_string(row.line); };
  CUTIS_TRY(columns, columnsOf(rows[0], placeOf(rows[0])));
  std::vector<ParameterVector> sets;
  sets.reserve(rows.size() - 1);
  std::vector<std::string_view> fields(kParameterCount);
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const CsvRow& row = rows[r];
    if (row.fields.size() != kParameterCount) {
      return inputError(placeOf(row), "the row has " + std::to_string(row.fields.size()) +
                                          " values where the header has five");
    }
    for (std::size_t k = 0; k < columns.size(); ++k)
      fields[k] = row.fields[columns[k]];
    CUTIS_TRY(set, parseParameters(fields, axes, placeOf(row), ErrorKind::input));
    sets.push_back(set);
  }
  return sets;
}

}  // namespace cutis
