#include "ui/spectrum/spectrum_text.h"

#include <cmath>

#include "core/base/number_text.h"

namespace cutis {
namespace {

constexpr int kDigits = 6;

struct Column {
  std::string name;
  const QVector<double>& values;
};

void addPlace(const std::string& prefix, const PlaceCurves& place, std::vector<Column>& columns) {
  const auto add = [&](const char* name, const QVector<double>& values) {
    if (!values.isEmpty()) columns.push_back({prefix + name, values});
  };
  add("original", place.original);
  add("deviation", place.deviation);
  add("edited", place.edited);
}

std::string numberOrNothing(double value) {
  return std::isfinite(value) ? formatNumber(value, kDigits) : std::string();
}

std::string quoted(const std::string& field, char separator) {
  if (field.find_first_of(std::string("\"\n\r") + separator) == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field)
    text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

std::string columnsText(const std::vector<Column>& columns, char separator) {
  std::vector<std::string> fields = {"wavelength_nm"};
  for (const Column& column : columns)
    fields.push_back(column.name);
  std::string text = tableRow(fields, separator);
  for (int sample = 0; sample < kSampleCount; ++sample) {
    fields = {formatNumber(wavelengthNm(sample), kDigits)};
    for (const Column& column : columns)
      fields.push_back(numberOrNothing(column.values[sample]));
    text += tableRow(fields, separator);
  }
  return text;
}

std::string partsText(const SpectrumFigure& figure, char separator) {
  std::vector<Column> columns;
  for (const NamedCurve& part : figure.parts)
    columns.push_back({part.name.toStdString(), part.values});
  return columnsText(columns, separator);
}

}  // namespace

std::string tableRow(const std::vector<std::string>& fields, char separator) {
  std::string text;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) text += separator;
    text += quoted(fields[i], separator);
  }
  return text + '\n';
}

std::string curvesText(const SpectrumFigure& figure, char separator) {
  if (figure.quantity != SpectrumQuantity::reflectance) return partsText(figure, separator);
  std::vector<Column> columns;
  addPlace({}, figure.place, columns);
  for (const PinnedCurves& pin : figure.pins) {
    const QString title = pin.name.isEmpty() ? pin.letter : pin.letter + ' ' + pin.name;
    addPlace(title.toStdString() + ' ', pin.curves, columns);
  }
  for (const NamedCurve& reference : figure.references)
    columns.push_back({reference.name.toStdString(), reference.values});
  return columnsText(columns, separator);
}

}  // namespace cutis
