#include "src/files/io/csv.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace cutis {

std::string_view withoutBlanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

class CsvSplitter {
 public:
  CsvSplitter(std::string_view text, char separator) : text_(text), separator_(separator) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    if (text_.find('\n') == std::string_view::npos) lineEnd_ = '\r';
  }

  CsvTable split() {
    while (next_ < text_.size()) {
      const std::size_t end = lineEndFrom(next_);
      const std::string_view line = text_.substr(next_, end - next_);
      const std::string_view content = withoutBlanks(line);
      ++line_;
      if (content.empty() || content.front() == '#') {
        next_ = end + 1;
        continue;
      }
      beginRow();
      if (line.find('"') == std::string_view::npos) {
        splitPlain(line);
        next_ = end + 1;
      } else {
        splitQuoted();
      }
    }
    std::size_t first = 0;
    for (std::size_t r = 0; r < table_.rows_.size(); ++r) {
      const std::size_t after = r + 1 < starts_.size() ? starts_[r + 1] : table_.fields_.size();
      table_.rows_[r].fields = std::span(table_.fields_).subspan(first, after - first);
      first = after;
    }
    return std::move(table_);
  }

  static CsvTable made(std::vector<std::string_view> fields, const std::vector<std::size_t>& widths,
                       const std::vector<int>& lines) {
    CsvTable table;
    table.fields_ = std::move(fields);
    std::size_t first = 0;
    for (std::size_t r = 0; r < widths.size(); ++r) {
      table.rows_.push_back({lines[r], std::span(table.fields_).subspan(first, widths[r])});
      first += widths[r];
    }
    assert(first == table.fields_.size());
    return table;
  }

 private:
  std::size_t lineEndFrom(std::size_t position) const {
    const auto end = text_.find(lineEnd_, position);
    return end == std::string_view::npos ? text_.size() : end;
  }

  void beginRow() {
    starts_.push_back(table_.fields_.size());
    table_.rows_.push_back({line_, {}});
  }

  bool isBlank(char c) const {
    return (c == ' ' || c == '\t' || (c == '\r' && lineEnd_ != '\r')) &&
           (c != separator_ || separator_ == kBlanks);
  }
  bool separates(char c) const {
    return separator_ == kBlanks ? c == ' ' || c == '\t' : c == separator_;
  }

  void splitPlain(std::string_view line) {
    if (separator_ == kBlanks) {
      std::size_t at = 0;
      while ((at = line.find_first_not_of(" \t\r", at)) != std::string_view::npos) {
        const auto end = std::min(line.find_first_of(" \t\r", at), line.size());
        table_.fields_.push_back(line.substr(at, end - at));
        at = end;
      }
      return;
    }
    while (true) {
      const auto end = line.find(separator_);
      table_.fields_.push_back(withoutBlanks(line.substr(0, end)));
      if (end == std::string_view::npos) return;
      line.remove_prefix(end + 1);
    }
  }

  // The field in quotes that opens at `open`, if it closes before a separator or the end of a line;
  // moves next_ behind it.
  bool takeQuoted(std::size_t open) {
    if (table_.unclosedQuoteLine_ != 0) return false;
    bool doubled = false;
    std::size_t close = open + 1;
    while (true) {
      close = text_.find('"', close);
      if (close == std::string_view::npos) {
        table_.unclosedQuoteLine_ = line_;
        return false;
      }
      if (close + 1 >= text_.size() || text_[close + 1] != '"') break;
      doubled = true;
      close += 2;
    }
    std::size_t after = close + 1;
    while (after < text_.size() && isBlank(text_[after]))
      ++after;
    const bool isEnd = after >= text_.size() || text_[after] == lineEnd_;
    const bool isNext =
        !isEnd && (separates(text_[after]) || (separator_ == kBlanks && after > close + 1));
    if (!isEnd && !isNext) return false;
    addQuoted(text_.substr(open + 1, close - open - 1), doubled);
    next_ = after;
    return true;
  }

  void addQuoted(std::string_view content, bool doubled) {
    for (const char c : content) {
      if (c == lineEnd_) ++line_;
      if (c == ',') table_.hasQuotedComma_ = true;
    }
    if (!doubled) {
      table_.fields_.push_back(content);
      return;
    }
    std::string& text = table_.unescaped_.emplace_back();
    for (std::size_t i = 0; i < content.size(); ++i) {
      text += content[i];
      if (content[i] == '"') ++i;
    }
    table_.fields_.push_back(text);
  }

  // From next_ to the end of the row.
  void splitQuoted() {
    while (true) {
      while (next_ < text_.size() && isBlank(text_[next_]))
        ++next_;
      const bool atEnd = next_ >= text_.size() || text_[next_] == lineEnd_;
      if (atEnd && separator_ == kBlanks) break;
      if (atEnd || text_[next_] != '"' || !takeQuoted(next_)) takePlain();
      if (next_ >= text_.size() || text_[next_] == lineEnd_) break;
      if (separator_ != kBlanks) ++next_;  // the separator
    }
    ++next_;
  }

  void takePlain() {
    const std::size_t end = lineEndFrom(next_);
    std::size_t after = next_;
    while (after < end && !separates(text_[after]))
      ++after;
    table_.fields_.push_back(withoutBlanks(text_.substr(next_, after - next_)));
    next_ = after;
  }

  std::string_view text_;
  char separator_;
  char lineEnd_ = '\n';
  std::size_t next_ = 0;
  int line_ = 0;
  std::vector<std::size_t> starts_;
  CsvTable table_;
};

CsvTable splitCsv(std::string_view text, char separator) {
  return CsvSplitter(text, separator).split();
}

CsvTable tableOf(std::vector<std::string_view> fields, const std::vector<std::size_t>& widths,
                 const std::vector<int>& lines) {
  return CsvSplitter::made(std::move(fields), widths, lines);
}

}  // namespace cutis
