#include "src/cli/commands/validate/capture_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.h"
#include "src/cli/text_table.h"

namespace cutis {
namespace {

constexpr int kErrorDecimals = 4;
constexpr int kCsvDigits = 6;
constexpr std::array<const char*, kCaptureGroups> kGroupWords = {"", " dark", " middle", " light"};

const char* wordOf(CaptureScheme scheme) {
  switch (scheme) {
    case CaptureScheme::asShipped:
      return "as-shipped";
    case CaptureScheme::withoutDiscrepancy:
      return "without-discrepancy";
    case CaptureScheme::peopleLeftOut:
      return "people-left-out";
    case CaptureScheme::foldLeftOut:
      return "fold-left-out";
    case CaptureScheme::setLeftOut:
      break;
  }
  return "set-left-out";
}

std::string wordsOf(const WavelengthRange& range) {
  return formatNumber(range.fromNm) + "-" + formatNumber(range.toNm);
}

std::string csvCell(double value) {
  return std::isnan(value) ? std::string() : formatNumber(value, kCsvDigits);
}

std::string learnedWords(const CaptureResult& result, const CaptureNames& names) {
  if (result.scheme != CaptureScheme::setLeftOut) return {};
  return " from " + names.sets[result.learnedFrom];
}

std::string percentCell(double share) {
  return std::isnan(share) ? "-" : percentText(share, 3);
}

}  // namespace

std::string nameOf(const CaptureResult& result, const CaptureNames& names) {
  switch (result.estimator) {
    case CaptureEstimator::wiener:
      return "wiener";
    case CaptureEstimator::quadraticWiener:
      return "wiener2";
    case CaptureEstimator::refined:
      break;
  }
  return names.models.size() > 1 ? "refined " + names.models[result.model] : "refined";
}

std::string schemeOf(const CaptureResult& result, const CaptureNames& names) {
  std::string words = wordOf(result.scheme);
  if (names.sets.size() > 1) words += " " + names.sets[result.set];
  return words + learnedWords(result, names);
}

std::string captureCsv(const std::vector<CaptureResult>& results, const CaptureNames& names) {
  std::string text = "name,scheme,range,median,p95,worst,coverage\n";
  for (const CaptureResult& result : results) {
    for (std::size_t group = 0; group < kCaptureGroups; ++group) {
      for (std::size_t range = 0; range < kCaptureRanges.size(); ++range) {
        const CaptureFigures& figures = result.figures[group][range];
        if (std::isnan(figures.median)) continue;
        text += nameOf(result, names) + "," + schemeOf(result, names) + kGroupWords[group] + "," +
                wordsOf(kCaptureRanges[range]);
        for (const double value :
             {figures.median, figures.within95, figures.worst, figures.coverage})
          text += "," + csvCell(value);
        text += "\n";
      }
    }
  }
  return text;
}

std::string captureTables(const std::vector<CaptureResult>& results, std::size_t set,
                          const MeasuredSpectra& spectra, const CaptureNames& names) {
  std::string text;
  for (std::size_t range = 0; range < kCaptureRanges.size(); ++range) {
    const WavelengthRange part =
        measuredPart(spectra, kCaptureRanges[range]).value_or(kCaptureRanges[range]);
    TextTable table({wordsOf(part) + " nm", "scheme", "median", "95 % within", "worst",
                     "two deviations hold", "dark", "middle", "light"},
                    2);
    bool isKnown = false;
    for (const CaptureResult& result : results) {
      if (result.set != set) continue;
      const CaptureFigures& all = result.figures[0][range];
      isKnown = isKnown || !std::isnan(all.median);
      std::vector<std::string> row = {nameOf(result, names),
                                      wordOf(result.scheme) + learnedWords(result, names)};
      for (const double value : {all.median, all.within95, all.worst})
        row.push_back(fixedNumber(value, kErrorDecimals));
      row.push_back(percentCell(all.coverage));
      for (std::size_t group = 1; group < kCaptureGroups; ++group)
        row.push_back(fixedNumber(result.figures[group][range].median, kErrorDecimals));
      table.add(row);
    }
    if (isKnown) text += "\n" + table.text();
  }
  return text;
}

}  // namespace cutis
