#include "src/files/io/csv.h"

namespace cutis {
namespace {

std::string_view trimmed(std::string_view field) {
  constexpr std::string_view blanks = " \t\r";
  const auto first = field.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  field = field.substr(first, field.find_last_not_of(blanks) - first + 1);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
    field = field.substr(1, field.size() - 2);
  }
  return field;
}

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const auto comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

std::vector<CsvRow> splitCsv(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<CsvRow> rows;
  int number = 0;
  while (!text.empty()) {
    ++number;
    const auto end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const std::string_view content = trimmed(line);
    if (content.empty() || content.front() == '#') continue;
    rows.push_back({number, fieldsOf(line)});
  }
  return rows;
}

}  // namespace cutis
