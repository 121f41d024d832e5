#include "src/files/spectra/cgats.h"

#include <algorithm>
#include <vector>

#include "src/files/spectra/wavelength_text.h"

namespace cutis {
namespace {

constexpr std::string_view kBeginFormat = "BEGIN_DATA_FORMAT";
constexpr std::string_view kEndFormat = "END_DATA_FORMAT";
constexpr std::string_view kBeginData = "BEGIN_DATA";
constexpr std::string_view kEndData = "END_DATA";

// The format stands within these.
constexpr std::size_t kMostHeaderBytes = std::size_t{1} << 20;

struct CgatsField {
  std::string_view text;
  int line = 0;
};

// Fields of the rows after `row` up to one that begins with `end`, where `row` stands then.
std::vector<CgatsField> fieldsUntil(std::string_view end, const CsvTable& rows, std::size_t& row) {
  std::vector<CgatsField> fields;
  for (++row; row < rows.size() && rows[row].fields.front() != end; ++row) {
    for (const std::string_view field : rows[row].fields)
      fields.push_back({field, rows[row].line});
  }
  return fields;
}

bool hasSpectra(const std::vector<CgatsField>& format) {
  WavelengthFormat labels;
  labels.labelled = true;
  return std::count_if(format.begin(), format.end(), [&](const CgatsField& field) {
           return looksLikeWavelength(field.text, labels);
         }) > 1;
}

// Fields that are no wavelength come first, and of these what names a sample best.
std::vector<std::size_t> orderOf(const std::vector<CgatsField>& format) {
  WavelengthFormat labels;
  labels.labelled = true;
  const auto rank = [&](std::size_t i) {
    const std::string name = loweredText(format[i].text);
    if (looksLikeWavelength(format[i].text, labels)) return 3;
    if (name == "sample_name" || name == "samplename") return 0;
    if (name == "sample_id" || name == "sampleid") return 1;
    return 2;
  };
  std::vector<std::size_t> order(format.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

Result<CsvTable> tableFrom(const std::vector<CgatsField>& format,
                           const std::vector<CgatsField>& data, const std::string& place) {
  const std::vector<std::size_t> order = orderOf(format);
  const std::size_t width = format.size();
  std::vector<std::string_view> fields;
  std::vector<std::size_t> widths;
  std::vector<int> lines;
  fields.reserve(width + data.size());
  const auto add = [&](const CgatsField* row) {
    for (const std::size_t i : order)
      fields.push_back(row[i].text);
    widths.push_back(width);
    lines.push_back(row[0].line);
  };
  add(format.data());
  for (std::size_t first = 0; first < data.size(); first += width) {
    if (first + width > data.size()) {
      return inputError(place + ":" + std::to_string(data[first].line),
                        "the last set has " + std::to_string(data.size() - first) +
                            " values where the format names " + std::to_string(width) +
                            " fields; complete or correct it");
    }
    if (data[first].line != data[first + width - 1].line && first > 0 &&
        data[first].line == data[first - 1].line) {
      return inputError(place + ":" + std::to_string(data[first].line),
                        "the sets do not have the " + std::to_string(width) +
                            " values that the format names; complete or correct them");
    }
    add(data.data() + first);
  }
  return tableOf(std::move(fields), widths, lines);
}

}  // namespace

bool isCgats(std::string_view text) {
  const std::string_view head = text.substr(0, kMostHeaderBytes);
  return head.find(kBeginFormat) != std::string_view::npos &&
         head.find(kBeginData, head.find(kEndFormat)) != std::string_view::npos;
}

Result<CgatsTable> splitCgats(std::string_view text, const std::string& place) {
  CgatsTable result;
  result.source = splitCsv(text, kBlanks);
  const CsvTable& rows = result.source;
  std::vector<CgatsField> format;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::string_view keyword = rows[r].fields.front();
    if (keyword == kBeginFormat) {
      format = fieldsUntil(kEndFormat, rows, r);
    } else if (keyword == kBeginData) {
      const int line = rows[r].line;
      const std::vector<CgatsField> data = fieldsUntil(kEndData, rows, r);
      if (!hasSpectra(format)) continue;
      if (++result.tables > 1) continue;
      if (r >= rows.size()) {
        return inputError(place + ":" + std::to_string(line),
                          "the data that begin here have no END_DATA; the file is not complete");
      }
      CUTIS_TRY(table, tableFrom(format, data, place));
      result.table = std::move(table);
    }
  }
  if (result.tables > 0) return result;
  return inputError(place,
                    "this CGATS file names no spectral fields such as SPECTRAL_NM380; export it "
                    "with spectra");
}

}  // namespace cutis
