#include "src/files/spectra/measured_spectra_file.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/number_text.h"
#include "src/files/io/text_file.h"
#include "src/files/spectra/emission_words.h"
#include "src/files/spectra/spectra_text.h"

namespace cutis {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30;
constexpr double kPercent = 100.0;

class MeasuredReader {
 public:
  MeasuredReader(const SpectraText& file, const std::string& place, const WavelengthRange& range,
                 std::size_t fewest, const JobContext& context)
      : file_(file), place_(place), range_(range), fewest_(fewest), context_(context) {}

  Result<MeasuredSpectra> read() {
    CUTIS_CHECK(takeWavelengths());
    spectra_.ids.reserve(layout().spectrumCount());
    for (const std::string& name : layout().names) {
      spectra_.ids.push_back(name.empty() ? std::to_string(spectra_.ids.size() + 1) : name);
    }
    CUTIS_CHECK(takeValues());
    CUTIS_CHECK(decideScale());
    for (const std::string& note : layout().notes)
      context_.say(note);
    questionEmission();
    return std::move(spectra_);
  }

 private:
  const SpectralLayout& layout() const { return file_.layout; }
  std::size_t count() const { return spectra_.wavelengthsNm.size(); }

  // Files of lights have numbers that could be reflectances.
  void questionEmission() const {
    const auto found = emissionWordAbove(*file_.text, layout().firstLine());
    if (!found) return;
    context_.say(place_ + ":" + std::to_string(found->line) + ": '" + found->word +
                 "' speaks of light that is emitted; check that this file holds reflectances");
  }

  Status takeWavelengths() {
    const std::vector<double>& all = layout().wavelengthsNm;
    for (std::size_t w = 0; w < all.size(); ++w) {
      if (!range_.contains(all[w])) continue;
      if (spectra_.wavelengthsNm.empty()) first_ = w;
      spectra_.wavelengthsNm.push_back(all[w]);
    }
    if (count() >= fewest_) return {};
    return inputError(layout().headerPlace,
                      "too few wavelengths lie from " + formatNumber(range_.fromNm) + " to " +
                          formatNumber(range_.toNm) + " nm: " + std::to_string(count()) +
                          " where at least " + std::to_string(fewest_) + " are needed");
  }

  Status takeValue(std::size_t s, std::size_t w) {
    CUTIS_TRY(value, numberIn(file_, s, first_ + w));
    if (value < 0.0) {
      return inputError(layout().placeOf(s, first_ + w),
                        "the reflectance " + formatNumber(value) +
                            " is negative; correct it or leave its wavelength out");
    }
    if (layout().cell(s, first_ + w).ends_with('%')) cellsSayPercent_ = true;
    spectra_.reflectances[s * count() + w] = value;
    return {};
  }

  // In the order of the file, which is that of its errors, too.
  Status takeValues() {
    const std::size_t spectra = layout().spectrumCount();
    spectra_.reflectances.resize(spectra * count());
    const bool columns = layout().inColumns();
    const std::size_t outer = columns ? count() : spectra;
    const std::size_t inner = columns ? spectra : count();
    for (std::size_t i = 0; i < outer; ++i) {
      if (context_.stopRequested()) return Cancelled{};
      for (std::size_t k = 0; k < inner; ++k)
        CUTIS_CHECK(columns ? takeValue(k, i) : takeValue(i, k));
    }
    return {};
  }

  Error notLikeOthers(std::size_t index, const std::string& what) const {
    return inputError(layout().placeOf(index / count(), first_ + index % count()),
                      "the reflectance " + formatNumber(spectra_.reflectances[index]) + what);
  }

  static bool isLarge(double value) { return value > kMostReflectance; }

  // Percent where the file declares it, else by what most values can be. Cells with a sign of their
  // own have become shares.
  Status decideScale() {
    const std::vector<double>& values = spectra_.reflectances;
    const auto large =
        static_cast<std::size_t>(std::count_if(values.begin(), values.end(), isLarge));
    if (!layout().percentPlace.empty() && !cellsSayPercent_) return takeDeclaredPercent(large);
    if (large == 0) return {};
    if (2 * large <= values.size()) {
      const auto first = std::find_if(values.begin(), values.end(), isLarge);
      return notLikeOthers(static_cast<std::size_t>(first - values.begin()),
                           " is not a share from 0 to 1 as most others are; correct it");
    }
    CUTIS_CHECK(checkPercent());
    takeAsPercent();
    context_.say(place_ + ": reflectances are read as percent, since most are above " +
                 formatNumber(kMostReflectance));
    return {};
  }

  Status takeDeclaredPercent(std::size_t large) {
    CUTIS_CHECK(checkPossible());
    takeAsPercent();
    std::string sentence =
        layout().percentPlace + ": reflectances are read as percent, as declared";
    if (large == 0) {
      sentence += " here, though none is above " + formatNumber(kMostReflectance) +
                  " %; if they are shares from 0 to 1, correct this line";
    }
    context_.say(sentence);
    return {};
  }

  void takeAsPercent() {
    for (double& value : spectra_.reflectances)
      value /= kPercent;
  }

  std::size_t largestOf(std::size_t spectrum) const {
    const std::vector<double>& values = spectra_.reflectances;
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(spectrum * count());
    const auto most = std::max_element(begin, begin + static_cast<std::ptrdiff_t>(count()));
    return static_cast<std::size_t>(most - values.begin());
  }

  // None has more than a diffuser reflects.
  Status checkPossible() const {
    for (std::size_t s = 0; s < spectra_.ids.size(); ++s) {
      const std::size_t index = largestOf(s);
      if (spectra_.reflectances[index] > kPercent * kMostReflectance) {
        return notLikeOthers(index, " is neither a share from 0 to 1 nor percent; correct it");
      }
    }
    return {};
  }

  // Each spectrum is in percent.
  Status checkPercent() const {
    CUTIS_CHECK(checkPossible());
    for (std::size_t s = 0; s < spectra_.ids.size(); ++s) {
      const std::size_t index = largestOf(s);
      if (!isLarge(spectra_.reflectances[index])) {
        return notLikeOthers(index,
                             " is the largest of its spectrum, where other spectra are in percent; "
                             "write all of them alike");
      }
    }
    return {};
  }

  const SpectraText& file_;
  const std::string& place_;
  const WavelengthRange& range_;
  const std::size_t fewest_;
  const JobContext& context_;
  std::size_t first_ = 0;  // of the wavelengths within the range
  bool cellsSayPercent_ = false;
  MeasuredSpectra spectra_;
};

Result<MeasuredSpectra> measuredSpectra(std::string bytes, const std::string& place,
                                        const WavelengthRange& range, std::size_t fewest,
                                        const JobContext& context) {
  CUTIS_TRY(file, takeApart(std::move(bytes), {}, place));
  return MeasuredReader(file, place, range, fewest, context).read();
}

}  // namespace

Result<MeasuredSpectra> parseMeasuredSpectra(std::string_view text, const std::string& place,
                                             const WavelengthRange& range, std::size_t fewest,
                                             const JobContext& context) {
  return measuredSpectra(std::string(text), place, range, fewest, context);
}

Result<MeasuredSpectra> readMeasuredSpectra(const std::filesystem::path& path,
                                            const WavelengthRange& range, std::size_t fewest,
                                            const JobContext& context) {
  CUTIS_TRY(text, readTextFile(path, kLargestFile));
  return measuredSpectra(std::move(text), path.string(), range, fewest, context);
}

}  // namespace cutis
