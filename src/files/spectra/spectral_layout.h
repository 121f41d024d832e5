#pragma once  // internal to src/files/spectra

// Where the spectra are in a table: which row or column has the wavelengths, what is named where,
// and what belongs to something else.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "src/files/io/csv.h"
#include "src/files/spectra/wavelength_search.h"

namespace cutis {

struct LayoutOptions {
  Orientation preferred = Orientation::rows;
  bool labelled = false;  // wavelengths are known to be labels, as in CGATS
};

class SpectralLayout {
 public:
  std::vector<double> wavelengthsNm;  // strictly increasing
  std::vector<std::string> names;     // one per spectrum; may be empty
  std::string headerPlace;            // "file:line"
  std::vector<std::string> notes;     // sentences on what was left out
  std::string percentPlace;           // "file:line" that declares percent; may be empty

  std::size_t wavelengthCount() const { return wavelengthsNm.size(); }
  std::size_t spectrumCount() const { return names.size(); }
  bool inColumns() const { return inColumns_; }

  // A cell, and whether its row has it at all.
  bool has(std::size_t spectrum, std::size_t wavelength) const {
    return columnAt(spectrum, wavelength) < rowAt(spectrum, wavelength).fields.size();
  }
  std::string_view cell(std::size_t spectrum, std::size_t wavelength) const {
    return rowAt(spectrum, wavelength).fields[columnAt(spectrum, wavelength)];
  }
  // The first of the file's lines that holds values.
  int firstLine() const;
  // "file:line, column"
  std::string placeOf(std::size_t spectrum, std::size_t wavelength) const;
  // Why a row does not have a cell.
  Error shortRow(std::size_t spectrum, std::size_t wavelength) const;

 private:
  friend class LayoutFinder;
  const CsvRow& rowAt(std::size_t spectrum, std::size_t wavelength) const {
    return *(inColumns_ ? wavelengthRows_[wavelength] : spectrumRows_[spectrum]);
  }
  std::size_t columnAt(std::size_t spectrum, std::size_t wavelength) const {
    return inColumns_ ? spectrumColumns_[spectrum] : wavelengthColumns_[wavelength];
  }

  std::string place_;
  bool inColumns_ = false;
  std::size_t width_ = 0;  // of the header
  std::vector<const CsvRow*> spectrumRows_, wavelengthRows_;
  std::vector<std::size_t> spectrumColumns_, wavelengthColumns_;
};

// The layout refers to the table, which outlives it. Errors name line and column: of wavelengths
// that are none, appear twice or neither increase nor decrease, of rows that are too long. `place`
// stands in front.
Result<SpectralLayout> findLayout(const CsvTable& table, const NumberFormat& numbers,
                                  const LayoutOptions& options, const std::string& place);

}  // namespace cutis
