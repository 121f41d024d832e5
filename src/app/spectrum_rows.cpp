#include "src/app/spectrum_rows.h"

#include <algorithm>
#include <string>

#include "core/base/number_text.h"
#include "core/base/parallel.h"

namespace cutis {
namespace {

constexpr int kDigits = 9;
// Rows of a piece of work, and pieces between two writes.
constexpr std::size_t kRowsPerPiece = 64;
constexpr std::size_t kPiecesPerWrite = 64;

void appendRow(const InstrumentModel& model, const ParameterVector& set, std::string& text) {
  const Spectrum spectrum = model.reflectance(set);
  for (int i = 0; i < kSampleCount; ++i) {
    if (i > 0) text += ',';
    text += formatNumber(spectrum[i], kDigits);
  }
  text += '\n';
}

std::string headerRow() {
  std::string text;
  for (int i = 0; i < kSampleCount; ++i) {
    if (i > 0) text += ',';
    text += std::to_string(kFirstWavelengthNm + kWavelengthStepNm * i);
  }
  return text + "\n";
}

}  // namespace

Status writeSpectra(const InstrumentModel& model, const std::vector<ParameterVector>& sets,
                    const std::function<Status(std::string_view text)>& write,
                    const JobContext& context) {
  CUTIS_CHECK(write(headerRow()));
  constexpr std::size_t rowsPerWrite = kRowsPerPiece * kPiecesPerWrite;
  std::vector<std::string> pieces;
  for (std::size_t begin = 0; begin < sets.size(); begin += rowsPerWrite) {
    const std::size_t end = std::min(begin + rowsPerWrite, sets.size());
    pieces.assign((end - begin + kRowsPerPiece - 1) / kRowsPerPiece, std::string());
    const auto total = static_cast<double>(sets.size());
    const JobContext part = context.child(static_cast<double>(begin) / total,
                                          static_cast<double>(end) / total, "spectra");
    CUTIS_CHECK(parallelFor(pieces.size(), part, [&](std::size_t i) -> Status {
      const std::size_t first = begin + i * kRowsPerPiece;
      const std::size_t last = std::min(first + kRowsPerPiece, end);
      for (std::size_t r = first; r < last; ++r)
        appendRow(model, sets[r], pieces[i]);
      return {};
    }));
    for (const std::string& piece : pieces)
      CUTIS_CHECK(write(piece));
  }
  return {};
}

}  // namespace cutis
