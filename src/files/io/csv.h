#pragma once

// Rows of separated text, by the rules of RFC 4180.
//
// `#` starts a comment line; empty lines are passed over; fields are trimmed of blanks and carriage
// returns. A field in double quotes may hold separators, line ends and doubled quotes; a quote
// elsewhere, or one that is never closed, is a character like others. Lines end with a line feed,
// with a carriage return before it or not, or with carriage returns alone. A byte order mark is
// passed over. Pure.

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cutis {

struct CsvRow {
  int line = 0;  // of its first field in the file, from 1
  std::span<const std::string_view> fields;
};

// Views into the text and into itself; moving it keeps them.
class CsvTable {
 public:
  CsvTable() = default;
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;
  CsvTable(CsvTable&&) = default;
  CsvTable& operator=(CsvTable&&) = default;

  bool empty() const { return rows_.empty(); }
  std::size_t size() const { return rows_.size(); }
  const CsvRow& operator[](std::size_t row) const { return rows_[row]; }
  auto begin() const { return rows_.begin(); }
  auto end() const { return rows_.end(); }
  // Where a quote opens that nothing closes; 0 if there is none.
  int unclosedQuoteLine() const { return unclosedQuoteLine_; }
  // Whether a field in quotes holds a comma.
  bool hasQuotedComma() const { return hasQuotedComma_; }

 private:
  friend class CsvSplitter;
  std::vector<std::string_view> fields_;
  std::vector<CsvRow> rows_;
  std::deque<std::string> unescaped_;
  int unclosedQuoteLine_ = 0;
  bool hasQuotedComma_ = false;
};

// A blank separates by runs of blanks and tabs.
inline constexpr char kBlanks = ' ';

// `separator` is a comma, a semicolon, a tab or kBlanks.
CsvTable splitCsv(std::string_view text, char separator = ',');

// Rows made elsewhere out of `fields`, which are views into a text that outlives them: `widths` has
// the number of fields of each row, `lines` where it begins.
CsvTable tableOf(std::vector<std::string_view> fields, const std::vector<std::size_t>& widths,
                 const std::vector<int>& lines);

// Without blanks and carriage returns at both ends.
std::string_view withoutBlanks(std::string_view text);

}  // namespace cutis
