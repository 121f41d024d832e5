#include "src/files/profiles/prior_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/skin/profile/parameter_names.h"

namespace cutis {
namespace {

using Json = nlohmann::ordered_json;
using Names = std::array<bool, kParameterCount>;

constexpr Names kNone = {};

Result<PriorScale> parseScale(const JsonValue& object) {
  CUTIS_TRY(scale, object.text("scale"));
  if (scale != "linear" && scale != "log") return object.error("scale", "\"linear\" or \"log\"");
  return scale == "log" ? PriorScale::log : PriorScale::linear;
}

// What "linear" lists.
Result<Names> parseLinear(const JsonValue& object) {
  Names listed = {};
  if (!object.has("linear")) return listed;
  CUTIS_TRY(elements, object.array("linear"));
  for (const JsonValue& element : elements) {
    CUTIS_TRY(name, element.asText());
    const auto parameter = parameterByName(name);
    if (!parameter) return element.error("the name of a parameter");
    listed[static_cast<std::size_t>(*parameter)] = true;
  }
  return listed;
}

// One of "mean", "sd". `optional` parameters may be left out.
Status parsePart(const JsonValue& prior, const std::string& key, const Names& optional,
                 ParameterVector& values) {
  const bool allOptional = std::find(optional.begin(), optional.end(), false) == optional.end();
  if (allOptional && !prior.has(key)) return {};
  CUTIS_TRY(part, prior.object(key));
  CUTIS_CHECK(part.allowOnly(parameterNames()));
  for (const Parameter parameter : kParameters) {
    const std::string name(parameterName(parameter));
    if (optional[static_cast<std::size_t>(parameter)] && !part.has(name)) continue;
    CUTIS_TRY(value, part.number(name));
    values[parameter] = value;
  }
  return {};
}

struct Pair {
  int first = 0;
  int second = 0;
};

std::optional<Pair> pairNamed(const std::string& key) {
  const auto comma = key.find(',');
  if (comma == std::string::npos) return std::nullopt;
  const auto first = parameterByName(std::string_view(key).substr(0, comma));
  const auto second = parameterByName(std::string_view(key).substr(comma + 1));
  if (!first || !second || *first == *second) return std::nullopt;
  return Pair{*first, *second};
}

Result<ParameterMatrix> parseCorrelation(const JsonValue& prior) {
  CUTIS_TRY(pairs, prior.object("correlation"));
  ParameterMatrix correlation = ParameterMatrix::Identity();
  Eigen::Matrix<bool, kParameterCount, kParameterCount> given;
  given.setConstant(false);
  for (const std::string& key : pairs.keys()) {
    const auto pair = pairNamed(key);
    if (!pair) {
      return pairs.error(key, "named by two parameters, as in \"melanin,melanin_blend\"");
    }
    const auto [i, j] = *pair;
    if (given(i, j)) return pairs.error(key, "given once, in one order of its parameters");
    CUTIS_TRY(value, pairs.number(key));
    if (!(value > -1.0 && value < 1.0)) return pairs.error(key, "between -1 and 1");
    given(i, j) = given(j, i) = true;
    correlation(i, j) = correlation(j, i) = value;
  }
  return correlation;
}

// Parameters `object` says something about.
Result<Names> namedParameters(const JsonValue& object, const Names& linear) {
  Names named = linear;
  for (const char* key : {"mean", "sd"}) {
    if (!object.has(key)) continue;
    CUTIS_TRY(part, object.object(key));
    for (const Parameter parameter : kParameters) {
      if (part.has(std::string(parameterName(parameter)))) {
        named[static_cast<std::size_t>(parameter)] = true;
      }
    }
  }
  return named;
}

// Sets the scale of every parameter; says whose numbers may be left out.
Names keepFromBase(const Prior& base, const Names& named, Prior& prior) {
  Names optional = {};
  for (std::size_t k = 0; k < named.size(); ++k) {
    const int parameter = static_cast<int>(k);
    if (!named[k]) prior.staysLinear[k] = base.staysLinear[k];
    optional[k] = prior.isLog(parameter) == base.isLog(parameter);
    if (optional[k]) continue;
    prior.correlation.row(parameter).setZero();
    prior.correlation.col(parameter).setZero();
    prior.correlation(parameter, parameter) = 1.0;
  }
  return optional;
}

Result<Prior> parseOver(const JsonValue& object, const Prior* base) {
  CUTIS_CHECK(object.allowOnly({"scale", "mean", "sd", "linear", "correlation"}));
  CUTIS_TRY(scale, parseScale(object));
  CUTIS_TRY(linear, parseLinear(object));
  const bool continues = base != nullptr && base->scale == scale;
  Prior prior = continues ? *base : Prior();
  prior.scale = scale;
  for (std::size_t k = 0; k < linear.size(); ++k)
    prior.staysLinear[k] = linear[k] || alwaysLinear()[k];
  Names optional = kNone;
  if (continues) {
    CUTIS_TRY(named, namedParameters(object, linear));
    optional = keepFromBase(*base, named, prior);
  }
  CUTIS_CHECK(parsePart(object, "mean", optional, prior.mean));
  CUTIS_CHECK(parsePart(object, "sd", optional, prior.deviation));
  if (object.has("correlation")) {
    CUTIS_TRY(correlation, parseCorrelation(object));
    prior.correlation = correlation;
  }
  return prior;
}

}  // namespace

Result<Prior> parsePrior(const JsonValue& object) {
  return parseOver(object, nullptr);
}

Result<Prior> readPrior(const std::string& path, const Prior& base) {
  CUTIS_TRY(root, readJson(path));
  CUTIS_TRY(prior, parseOver(root, &base));
  CUTIS_CHECK(validate(prior, path));
  return prior;
}

nlohmann::ordered_json priorJson(const Prior& prior) {
  const bool log = prior.scale == PriorScale::log;
  Json json = {{"scale", log ? "log" : "linear"}};
  Json linear = Json::array(), mean = Json::object(), sd = Json::object();
  Json correlation = Json::object();
  for (const Parameter parameter : kParameters) {
    const std::string name(parameterName(parameter));
    const bool mayBeLog = !alwaysLinear()[static_cast<std::size_t>(parameter)];
    if (log && mayBeLog && !prior.isLog(parameter)) linear.push_back(name);
    mean[name] = prior.mean[parameter];
    sd[name] = prior.deviation[parameter];
    for (const Parameter other : kParameters) {
      if (other <= parameter || prior.correlation(parameter, other) == 0.0) continue;
      correlation[name + "," + std::string(parameterName(other))] =
          prior.correlation(parameter, other);
    }
  }
  if (!linear.empty()) json["linear"] = linear;
  json["mean"] = mean;
  json["sd"] = sd;
  if (!correlation.empty()) json["correlation"] = correlation;
  return json;
}

}  // namespace cutis
