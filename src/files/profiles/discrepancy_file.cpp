#include "src/files/profiles/discrepancy_file.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "src/files/profiles/prior_file.h"

namespace cutis {
namespace {

constexpr int kStepsPerKnot = kKnotDistanceNm / kWavelengthStepNm;

Spectrum fromKnots(const std::vector<double>& knots) {
  Spectrum spectrum;
  for (int i = 0; i < kSampleCount; ++i) {
    const int below = std::min(i / kStepsPerKnot, kKnotCount - 2);
    const double share = static_cast<double>(i - below * kStepsPerKnot) / kStepsPerKnot;
    const auto knot = static_cast<std::size_t>(below);
    spectrum[i] = (1.0 - share) * knots[knot] + share * knots[knot + 1];
  }
  return spectrum;
}

Result<Spectrum> parseSpectrum(const JsonValue& list) {
  CUTIS_TRY(knots, list.asNumbers(kKnotCount));
  return fromKnots(knots);
}

// A list of spectra as columns.
Result<Eigen::MatrixXd> parseSpectra(const JsonValue& object, const std::string& key) {
  CUTIS_TRY(lists, object.array(key));
  Eigen::MatrixXd spectra(int{kSampleCount}, static_cast<Eigen::Index>(lists.size()));
  for (std::size_t i = 0; i < lists.size(); ++i) {
    CUTIS_TRY(spectrum, parseSpectrum(lists[i]));
    spectra.col(static_cast<Eigen::Index>(i)) = spectrum.matrix();
  }
  return spectra;
}

Result<Eigen::MatrixXd> parseMatrix(const JsonValue& object, const std::string& key,
                                    std::size_t columns) {
  CUTIS_TRY(lists, object.array(key));
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(lists.size()),
                         static_cast<Eigen::Index>(columns));
  for (std::size_t i = 0; i < lists.size(); ++i) {
    CUTIS_TRY(row, lists[i].asNumbers(columns));
    for (std::size_t j = 0; j < columns; ++j)
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = row[j];
  }
  return matrix;
}

Result<Discrepancy> parseDiscrepancy(const JsonValue& object) {
  CUTIS_CHECK(object.allowOnly(
      {"mean", "components", "slope", "covariance", "rest", "independent_deviation", "prior"}));
  Discrepancy discrepancy;
  CUTIS_TRY(meanList, object.list("mean"));
  CUTIS_TRY(mean, parseSpectrum(meanList));
  CUTIS_TRY(components, parseSpectra(object, "components"));
  CUTIS_TRY(slope, parseMatrix(object, "slope", kParameterCount));
  CUTIS_TRY(covariance,
            parseMatrix(object, "covariance", static_cast<std::size_t>(components.cols())));
  CUTIS_TRY(rest, parseSpectra(object, "rest"));
  Spectrum independent = Spectrum::Zero();
  if (object.has("independent_deviation")) {
    CUTIS_TRY(list, object.list("independent_deviation"));
    CUTIS_TRY(spectrum, parseSpectrum(list));
    independent = spectrum;
  }
  CUTIS_TRY(priorObject, object.object("prior"));
  CUTIS_TRY(prior, parsePrior(priorObject));
  return Discrepancy{mean, components, slope, covariance, rest, independent, prior};
}

}  // namespace

Result<Discrepancies> parseDiscrepancies(const JsonValue& profile) {
  Discrepancies discrepancies;
  if (!profile.has("discrepancy")) return discrepancies;
  CUTIS_TRY(object, profile.object("discrepancy"));
  CUTIS_CHECK(object.allowOnly({"surface_included", "surface_removed"}));
  if (object.has("surface_included")) {
    CUTIS_TRY(field, object.object("surface_included"));
    CUTIS_TRY(discrepancy, parseDiscrepancy(field));
    discrepancies.surfaceIncluded = discrepancy;
  }
  if (object.has("surface_removed")) {
    CUTIS_TRY(field, object.object("surface_removed"));
    CUTIS_TRY(discrepancy, parseDiscrepancy(field));
    discrepancies.surfaceRemoved = discrepancy;
  }
  return discrepancies;
}

}  // namespace cutis
