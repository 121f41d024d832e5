#include "src/app/spectrum_rows.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/fit/spectrum_posterior.h"
#include "core/render/skin_spectra.h"
#include "core/skin/parameter_buffer.h"

namespace cutis {
namespace {

constexpr int kDigits = 9;
// Rows of a piece of work, and pieces between two writes.
constexpr std::size_t kRowsPerPiece = 64;
constexpr std::size_t kPiecesPerWrite = 64;

void appendNumbers(const Spectrum& spectrum, std::string& text) {
  for (int i = 0; i < kSampleCount; ++i) {
    if (i > 0) text += ',';
    text += formatNumber(spectrum[i], kDigits);
  }
}

// The wavelengths, each behind a prefix.
std::string columnNames(const std::string& prefix) {
  std::string text;
  for (int i = 0; i < kSampleCount; ++i) {
    if (i > 0) text += ',';
    text += prefix + std::to_string(kFirstWavelengthNm + kWavelengthStepNm * i);
  }
  return text;
}

// append(row, text) adds a row's text, on any thread.
Status writeRows(std::size_t count, const std::function<void(std::size_t, std::string&)>& append,
                 const TextSink& write, const JobContext& context) {
  constexpr std::size_t rowsPerWrite = kRowsPerPiece * kPiecesPerWrite;
  std::vector<std::string> pieces;
  for (std::size_t begin = 0; begin < count; begin += rowsPerWrite) {
    const std::size_t end = std::min(begin + rowsPerWrite, count);
    pieces.assign((end - begin + kRowsPerPiece - 1) / kRowsPerPiece, std::string());
    const auto total = static_cast<double>(count);
    const JobContext part = context.child(static_cast<double>(begin) / total,
                                          static_cast<double>(end) / total, "spectra");
    CUTIS_CHECK(parallelFor(pieces.size(), part, [&](std::size_t i) -> Status {
      const std::size_t first = begin + i * kRowsPerPiece;
      const std::size_t last = std::min(first + kRowsPerPiece, end);
      for (std::size_t r = first; r < last; ++r)
        append(r, pieces[i]);
      return {};
    }));
    for (const std::string& piece : pieces)
      CUTIS_CHECK(write(piece));
  }
  return {};
}

// The spectra of some pixels of maps.
class MapSpectra {
 public:
  // posterior: null where deviations are not asked for.
  MapSpectra(const SkinSpectra& spectra, const ChromophoreMaps& maps, SkinConstants usual,
             const SpectrumPosterior* posterior)
      : spectra_(spectra), maps_(maps), usual_(usual), posterior_(posterior) {}

  // Writes the pixels of a rectangle that have an estimate.
  Status write(const Rect& rect, const TextSink& sink, const JobContext& context) const {
    CUTIS_TRY(buffer, loadParameters(maps_, rect));
    std::vector<std::size_t> present;
    for (std::size_t i = 0; i < buffer.count(); ++i) {
      if (buffer.present[i]) present.push_back(i);
    }
    const auto width = static_cast<std::size_t>(rect.width());
    const auto append = [&](std::size_t row, std::string& text) {
      const std::size_t i = present[row];
      text += std::to_string(rect.x0 + static_cast<int>(i % width)) + ',' +
              std::to_string(rect.y0 + static_cast<int>(i / width)) + ',';
      appendNumbers(spectrumOf(buffer, i), text);
      if (posterior_ != nullptr) {
        text += ',';
        appendNumbers(deviationOf(buffer, i), text);
      }
      text += '\n';
    };
    return writeRows(present.size(), append, sink, context);
  }

 private:
  Spectrum spectrumOf(const ParameterBuffer& buffer, std::size_t pixel) const {
    const PixelRows<const float> values = buffer.batch();
    ParameterVector parameters;
    for (int k = 0; k < kParameterCount; ++k)
      parameters[k] = double{values.at(static_cast<std::size_t>(k), pixel)};
    std::size_t row = kParameterCount;
    SkinConstants constants = usual_;
    for (const SkinConstant constant : kSkinConstants) {
      if (spectra_.free().has(constant)) constants[constant] = double{values.at(row++, pixel)};
    }
    std::vector<double> coefficients;
    while (row < values.rowCount)
      coefficients.push_back(double{values.at(row++, pixel)});
    return spectra_.reflectance(parameters, constants, coefficients);
  }

  // The measured channels are not in the maps; modelled ones have the same noise.
  Spectrum deviationOf(const ParameterBuffer& buffer, std::size_t pixel) const {
    const PixelRows<const float> rows = buffer.batch();
    std::vector<double> values;
    for (std::size_t k = 0; k < rows.rowCount; ++k)
      values.push_back(double{rows.at(k, pixel)});
    return posterior_->deviation(posterior_->channels(values), values);
  }

  const SkinSpectra& spectra_;
  const ChromophoreMaps& maps_;
  SkinConstants usual_;
  const SpectrumPosterior* posterior_;
};

Status checkDeviations(const ChromophoreMaps& maps, const FitRecord& record,
                       const SpectrumPosterior& posterior, const std::string& name) {
  if (maps.free().count() > 0 || record.free.count() > 0) {
    return inputError(name,
                      "nobody knows how far spectra with constants found for each pixel may be "
                      "off; leave the deviations out, or fit without free constants");
  }
  if (posterior.valueCount() == kParameterCount + maps.coefficients.size()) return {};
  return inputError(name,
                    "what the maps say of their fit does not go with what they hold; fit "
                    "the image again");
}

Status checkPlace(const ChromophoreMaps& maps, const PixelPlace& place, const std::string& name) {
  const std::string where = std::to_string(place.x) + "," + std::to_string(place.y);
  if (!maps.state.bounds().contains(place.x, place.y)) {
    return inputError(name, "pixel " + where + " lies outside of the maps, which are " +
                                std::to_string(maps.width()) + " × " +
                                std::to_string(maps.height()) + " pixels; pixels count from 0,0");
  }
  std::vector<float> state(1);
  CUTIS_CHECK(maps.state.load({place.x, place.y, place.x + 1, place.y + 1}, state));
  if (hasEstimate(pixelState(state[0]))) return {};
  return inputError(name, "pixel " + where + " has no estimate; choose one that was solved");
}

}  // namespace

Status writeSpectra(const InstrumentModel& model, const std::vector<ParameterVector>& sets,
                    const TextSink& write, const JobContext& context) {
  CUTIS_CHECK(write(columnNames({}) + "\n"));
  const auto append = [&](std::size_t row, std::string& text) {
    appendNumbers(model.reflectance(sets[row]), text);
    text += '\n';
  };
  return writeRows(sets.size(), append, write, context);
}

Status writeMapSpectra(const std::shared_ptr<const SkinModel>& model, const ChromophoreMaps& maps,
                       const MapSpectraOptions& options, const std::string& name,
                       const TextSink& write, const JobContext& context) {
  for (const PixelPlace& place : options.places)
    CUTIS_CHECK(checkPlace(maps, place, name));
  std::optional<SpectrumPosterior> posterior;
  if (options.deviationsOf) {
    posterior.emplace(*model, *options.deviationsOf);
    CUTIS_CHECK(checkDeviations(maps, *options.deviationsOf, *posterior, name));
  }
  CUTIS_TRY(spectra, SkinSpectra::make(model, maps.perPixel(), context.child(0.0, 0.0)));
  const MapSpectra rows(spectra, maps, constantsOf(model->profile()),
                        posterior ? &*posterior : nullptr);
  CUTIS_CHECK(write("x,y," + columnNames({}) + (posterior ? "," + columnNames("sd") : "") + "\n"));
  for (const PixelPlace& place : options.places) {
    CUTIS_CHECK(rows.write({place.x, place.y, place.x + 1, place.y + 1}, write,
                           {context.stop, {}, context.notice}));
  }
  if (!options.places.empty()) return {};
  for (int y = 0; y < maps.height(); ++y) {
    const double height = maps.height();
    CUTIS_CHECK(rows.write({0, y, maps.width(), y + 1}, write,
                           context.child(y / height, (y + 1) / height, "spectra")));
  }
  return {};
}

}  // namespace cutis
