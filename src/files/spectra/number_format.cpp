#include "src/files/spectra/number_format.h"

#include <cctype>

#include "core/base/number_text.h"

namespace cutis {
namespace {

// Enough to see the rows below a long header.
constexpr std::size_t kSampleBytes = std::size_t{1} << 17;
constexpr std::size_t kMostEchoed = 80;

bool isDigitAt(std::string_view text, std::size_t i) {
  return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
}

// The shape of a number whose marks are points and commas.
struct MarkedNumber {
  std::size_t points = 0, commas = 0;
  char last = '\0';              // of the marks
  bool grouped = false;          // all marks stand before exactly three digits
  bool lastBeforeThree = false;  // the last one does
};

// Digits with marks and perhaps an exponent; nothing for other text.
std::optional<MarkedNumber> markedNumber(std::string_view text) {
  std::size_t i = 0;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  MarkedNumber found;
  std::size_t digits = 0, sinceMark = 0;
  bool groups = true;
  const auto closeGroup = [&] {
    found.lastBeforeThree = found.last != '\0' && sinceMark == 3;
    if (found.last != '\0' && sinceMark != 3) groups = false;
  };
  for (; i < text.size() && (isDigitAt(text, i) || text[i] == '.' || text[i] == ','); ++i) {
    if (isDigitAt(text, i)) {
      ++digits;
      ++sinceMark;
      continue;
    }
    // Groups follow one to three digits that begin with no zero.
    if (found.last == '\0') {
      groups = digits >= 1 && digits <= 3 && text[i - digits] != '0';
    } else {
      closeGroup();
    }
    (text[i] == '.' ? found.points : found.commas) += 1;
    found.last = text[i];
    sinceMark = 0;
  }
  if (digits == 0) return std::nullopt;
  closeGroup();
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    groups = false;
    ++i;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    if (!isDigitAt(text, i)) return std::nullopt;
    while (isDigitAt(text, i))
      ++i;
  }
  if (i != text.size() || text.ends_with(',')) return std::nullopt;
  found.grouped = groups && found.last != '\0';
  return found;
}

// With a point for the decimal mark and without groups.
std::string normalised(std::string_view text, char decimal) {
  const char group = decimal == '.' ? ',' : '.';
  std::string plain;
  plain.reserve(text.size());
  for (const char c : text) {
    if (c == group) continue;
    plain += c == decimal ? '.' : c;
  }
  return plain;
}

bool readsAsNumber(std::string_view field) {
  if (field.ends_with('%')) field.remove_suffix(1);
  return parseNumber(field) || markedNumber(field);
}

// How well the fields of rows with numbers are numbers. A field of text counts half as much, since
// names and units stand beside numbers.
int numbersIn(const CsvTable& table) {
  int score = 0;
  for (const CsvRow& row : table) {
    if (row.fields.size() < 2) continue;
    int numbers = 0, texts = 0;
    for (const std::string_view field : row.fields) {
      if (!field.empty()) (readsAsNumber(field) ? numbers : texts) += 1;
    }
    if (numbers > 0) score += 2 * numbers - texts;
  }
  return score;
}

}  // namespace

char separatorOf(std::string_view text) {
  std::string_view sample = text.substr(0, kSampleBytes);
  if (sample.size() < text.size()) {
    const auto end = sample.find_last_of("\r\n");
    if (end != std::string_view::npos) sample = sample.substr(0, end);
  }
  char best = ',';
  int most = numbersIn(splitCsv(sample, best));
  const auto consider = [&](char separator) {
    const int score = numbersIn(splitCsv(sample, separator));
    if (score <= most) return;
    best = separator;
    most = score;
  };
  for (const char separator : {';', '\t'}) {
    if (sample.find(separator) != std::string_view::npos) consider(separator);
  }
  // Names have blanks in them, so that other separators come first.
  if (best == ',') consider(kBlanks);
  return best;
}

NumberFormat::NumberFormat(std::string_view text, const CsvTable& table, char separator) {
  const bool mayHaveCommas =
      separator == ',' ? table.hasQuotedComma() : text.find(',') != std::string_view::npos;
  if (!mayHaveCommas) return;
  std::size_t commas = 0, points = 0;
  for (const CsvRow& row : table) {
    for (const std::string_view field : row.fields) {
      const auto number = markedNumber(withoutBlanks(field));
      if (!number || number->last == '\0') continue;
      if (number->last == ',') ++commas;
      if (number->last == '.') ++points;
    }
  }
  decimalComma_ = commas > points;
}

std::optional<double> NumberFormat::parse(std::string_view field) const {
  if (!decimalComma_) {
    if (const auto number = parseNumber(field)) return number;
  }
  field = withoutBlanks(field);
  const auto marks = markedNumber(field);
  const char decimal = decimalComma_ ? ',' : '.';
  if (!marks || marks->last == '\0') return parseNumber(field);
  const std::size_t decimals = decimalComma_ ? marks->commas : marks->points;
  const std::size_t groups = decimalComma_ ? marks->points : marks->commas;
  if (decimals > 1) return std::nullopt;
  if (groups > 0 && (decimals == 0 || marks->last != decimal)) return std::nullopt;
  if (groups > 0) {
    const auto whole = markedNumber(field.substr(0, field.find(decimal)));
    if (!whole || !whole->grouped) return std::nullopt;
  }
  return parseNumber(normalised(field, decimal));
}

std::string NumberFormat::objection(std::string_view field) const {
  field = withoutBlanks(field);
  const auto marks = markedNumber(field);
  if (!marks || marks->last == '\0') return echoed(field) + " is not a finite number; correct it";
  const std::string usual = decimalComma_ ? "commas" : "points";
  if (marks->grouped && marks->last == (decimalComma_ ? '.' : ',')) {
    return echoed(field) + " may be a decimal number or thousands, where other numbers have " +
           "decimal " + usual + "; write it without a separator of thousands";
  }
  return echoed(field) + " is not written as the other numbers are, with decimal " + usual +
         "; write all of them alike";
}

std::string echoed(std::string_view field) {
  std::string text(field.substr(0, kMostEchoed));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  }
  if (field.size() > kMostEchoed) {
    // Not within a character of several bytes.
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80)
      text.pop_back();
    if (!text.empty() && (static_cast<unsigned char>(text.back()) & 0x80) != 0) text.pop_back();
    text += "…";
  }
  return "'" + text + "'";
}

}  // namespace cutis
