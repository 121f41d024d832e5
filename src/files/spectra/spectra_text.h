#pragma once  // internal to src/files/spectra

// A file of spectra taken apart: what every reader of spectra starts from.

#include <memory>
#include <string>

#include "core/base/result.h"
#include "src/files/spectra/spectral_layout.h"

namespace cutis {

// All of it refers to the text, which it keeps.
struct SpectraText {
  std::unique_ptr<const std::string> text;
  CsvTable source;  // which the table of a CGATS file refers to
  CsvTable table;
  NumberFormat numbers;
  SpectralLayout layout;
};

// Text in any encoding, of separated fields or CGATS, with whatever instruments write above the
// spectra. Errors name line and column; `place` stands in front.
Result<SpectraText> takeApart(std::string bytes, const LayoutOptions& options,
                              const std::string& place);

// A finite number, or why the cell is none.
Result<double> numberIn(const SpectraText& spectra, std::size_t spectrum, std::size_t wavelength);

}  // namespace cutis
