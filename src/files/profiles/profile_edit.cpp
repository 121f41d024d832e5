#include "src/files/profiles/profile_edit.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/base/echoed_text.h"
#include "core/skin/profile/prior.h"
#include "src/files/profiles/discrepancy_file.h"
#include "src/files/profiles/prior_file.h"

namespace cutis {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLineLength = 120;
// One over the last digit that a correlation is known to.
constexpr double kCorrelationDigits = 1e3;
constexpr double kDiscrepancyDigits = 1e5;

Json::json_pointer pointerTo(const std::string& field) {
  std::string path = "/" + field;
  std::replace(path.begin(), path.end(), '.', '/');
  return Json::json_pointer(path);
}

Json jsonOf(const Prior& prior) {
  Prior rounded = prior;
  for (double& correlation : rounded.correlation.reshaped())
    correlation = std::round(correlation * kCorrelationDigits) / kCorrelationDigits;
  return priorJson(rounded);
}

// What is known of relative reflectance: five digits after the point.
double rounded(double value) {
  return std::round(value * kDiscrepancyDigits) / kDiscrepancyDigits;
}

Json knotsOf(const Eigen::VectorXd& spectrum) {
  Json knots = Json::array();
  for (Eigen::Index i = 0; i < spectrum.size(); i += kKnotDistanceNm / kWavelengthStepNm)
    knots.push_back(rounded(spectrum[i]));
  return knots;
}

Json spectraOf(const Eigen::MatrixXd& columns) {
  Json spectra = Json::array();
  for (Eigen::Index i = 0; i < columns.cols(); ++i)
    spectra.push_back(knotsOf(columns.col(i)));
  return spectra;
}

Json rowsOf(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      row.push_back(rounded(matrix(i, j)));
    rows.push_back(row);
  }
  return rows;
}

Json jsonOf(const Discrepancy& discrepancy) {
  return {{"mean", knotsOf(discrepancy.mean.matrix())},
          {"components", spectraOf(discrepancy.components)},
          {"slope", rowsOf(discrepancy.slope)},
          {"covariance", rowsOf(discrepancy.covariance)},
          {"rest", spectraOf(discrepancy.rest)},
          {"independent_deviation", knotsOf(discrepancy.independentDeviation.matrix())},
          {"prior", jsonOf(discrepancy.prior)}};
}

Json jsonOf(const Discrepancies& discrepancies) {
  Json json = Json::object();
  for (const SurfaceLight surface : {SurfaceLight::included, SurfaceLight::removed}) {
    const Discrepancy* discrepancy = discrepancies.of(surface);
    if (discrepancy != nullptr) json["surface_" + surfaceLightName(surface)] = jsonOf(*discrepancy);
  }
  return json;
}

std::string written(const Json& json, std::size_t indent);

// The items of an object or array, each behind `separator`.
std::string joined(const Json& json, const std::string& separator, std::size_t indent) {
  std::string text;
  for (const auto& [key, value] : json.items()) {
    if (!text.empty()) text += "," + separator;
    if (json.is_object()) text += Json(key).dump() + ": ";
    text += written(value, indent);
  }
  return text;
}

// Objects and arrays without others inside stand on one line where there is room.
std::string written(const Json& json, std::size_t indent) {
  if (!json.is_structured()) return json.dump();
  const std::string open = json.is_object() ? "{" : "[", close = json.is_object() ? "}" : "]";
  const bool nested = std::any_of(json.begin(), json.end(),
                                  [](const Json& inner) { return inner.is_structured(); });
  const bool areNumbers = json.is_array() && !json.empty() && json.front().is_number();
  const std::string line = open + joined(json, " ", 0) + close;
  if (areNumbers || (!nested && line.size() + indent < kLineLength)) return line;
  const std::string separator = "\n" + std::string(indent + 2, ' ');
  return open + separator + joined(json, separator, indent + 2) + "\n" + std::string(indent, ' ') +
         close;
}

}  // namespace

Result<double> profileNumber(std::string_view text, const std::string& field,
                             const std::string& place) {
  const Json root = Json::parse(text);
  const Json::json_pointer pointer = pointerTo(field);
  if (root.contains(pointer) && root.at(pointer).is_number()) return root.at(pointer).get<double>();
  return inputError(place, "the profile has no number " + inQuotes(field));
}

std::string editedProfile(std::string_view text, const ProfileEdits& edits) {
  Json root = Json::parse(text);
  for (const auto& [field, value] : edits.numbers)
    root[pointerTo(field)] = value;
  if (!edits.name.empty()) root["name"] = edits.name;
  if (!edits.description.empty()) root["description"] = edits.description;
  if (edits.prior) root["prior"] = jsonOf(*edits.prior);
  if (!edits.discrepancies.empty()) root["discrepancy"] = jsonOf(edits.discrepancies);
  for (const auto& [field, source] : edits.sources)
    root["sources"][field] = source;
  return written(root, 0) + "\n";
}

}  // namespace cutis
