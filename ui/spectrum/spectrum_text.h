#pragma once  // internal to ui/spectrum

// The curves of a plot as a table for spreadsheets.

#include <string>

#include "ui/plot/spectrum_figure.h"

namespace cutis {

// A row per wavelength, a column per curve; a deviation stands behind the curve that it is of. Six
// significant digits, decimal points; what is not known is empty; fields that
// hold the separator are quoted as in RFC 4180.
std::string curvesText(const SpectrumFigure& figure, char separator);

// The fields of a row, ended by a line feed.
std::string tableRow(const std::vector<std::string>& fields, char separator);

}  // namespace cutis
