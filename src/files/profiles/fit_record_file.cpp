#include "src/files/profiles/fit_record_file.h"

#include <cstddef>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/number_text.h"
#include "core/skin/profile/parameter_names.h"
#include "src/files/io/json_file.h"
#include "src/files/profiles/prior_file.h"

namespace cutis {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kNewestRecord = 1;
constexpr int kResponseDigits = 8;

Json channelsJson(const FitRecord& record) {
  Json channels = Json::array();
  for (std::size_t k = 0; k < record.channels.size(); ++k) {
    Json response = Json::array();
    for (const double value : record.responses.row(static_cast<Eigen::Index>(k)))
      response.push_back(roundedTo(value, kResponseDigits));
    channels.push_back({{"name", record.channels[k]}, {"response", response}});
  }
  return channels;
}

Result<std::vector<std::string>> textsOf(const JsonValue& root, const std::string& key) {
  CUTIS_TRY(elements, root.array(key));
  std::vector<std::string> texts;
  for (const JsonValue& element : elements) {
    CUTIS_TRY(text, element.asText());
    texts.push_back(text);
  }
  return texts;
}

Status parseChannels(const JsonValue& root, FitRecord& record) {
  CUTIS_TRY(channels, root.array("channels"));
  record.responses.resize(static_cast<Eigen::Index>(channels.size()), int{kSampleCount});
  for (std::size_t k = 0; k < channels.size(); ++k) {
    if (!channels[k].isObject()) return channels[k].error("an object with a name and a response");
    CUTIS_TRY(name, channels[k].text("name"));
    CUTIS_TRY(list, channels[k].list("response"));
    CUTIS_TRY(response, list.asNumbers(kSampleCount));
    record.channels.push_back(name);
    record.responses.row(static_cast<Eigen::Index>(k)) =
        Eigen::Map<const Spectrum>(response.data()).transpose();
  }
  return {};
}

Result<NoiseModel> parseAssumedNoise(const JsonValue& root) {
  CUTIS_TRY(object, root.object("noise"));
  CUTIS_TRY(read, object.number("read"));
  CUTIS_TRY(proportional, object.number("proportional"));
  CUTIS_TRY(veil, object.number("veil", 0.0));
  return NoiseModel{read, proportional, veil};
}

Status parseAssumptions(const JsonValue& root, FitRecord& record) {
  CUTIS_TRY(noise, parseAssumedNoise(root));
  CUTIS_TRY(priorObject, root.object("prior"));
  CUTIS_TRY(prior, parsePrior(priorObject));
  CUTIS_TRY(fixed, root.object("fixed"));
  CUTIS_CHECK(fixed.allowOnly(parameterNames()));
  for (const std::string& name : fixed.keys()) {
    CUTIS_TRY(value, fixed.number(name));
    record.fixed[static_cast<std::size_t>(*parameterByName(name))] = value;
  }
  CUTIS_TRY(free, textsOf(root, "free"));
  for (const std::string& name : free) {
    if (name == constantName(kOxygenation)) record.free.oxygenation = true;
    if (name == constantName(kThickness)) record.free.thickness = true;
  }
  record.noise = noise;
  record.prior = prior;
  if (!root.has("shading")) return {};
  CUTIS_TRY(shading, root.number("shading"));
  record.shading = shading;
  return {};
}

}  // namespace

std::string fitRecordText(const FitRecord& record) {
  Json fixed = Json::object();
  for (const Parameter parameter : kParameters) {
    const auto& value = record.fixed[static_cast<std::size_t>(parameter)];
    if (value) fixed[std::string(parameterName(parameter))] = *value;
  }
  Json json = {{"cutis_fit", kNewestRecord},
               {"lights", record.lights},
               {"channels", channelsJson(record)},
               {"noise",
                {{"read", record.noise.read},
                 {"proportional", record.noise.proportional},
                 {"veil", record.noise.veil}}},
               {"prior", priorJson(record.prior)},
               {"fixed", fixed},
               {"free", constantNames(record.free)}};
  if (record.shading) json["shading"] = *record.shading;
  json["specular"] = surfaceLightName(record.surface);
  json["discrepancy"] = record.discrepancy;
  // Names of lights may be no UTF-8.
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Result<FitRecord> parseFitRecord(std::string_view text, const Profile& profile,
                                 const std::string& place) {
  CUTIS_TRY(root, parseJson(text, place));
  CUTIS_CHECK(checkVersion(root, "cutis_fit", kNewestRecord));
  FitRecord record;
  CUTIS_TRY(lights, textsOf(root, "lights"));
  record.lights = lights;
  CUTIS_CHECK(parseChannels(root, record));
  CUTIS_CHECK(parseAssumptions(root, record));
  CUTIS_TRY(specular, root.text("specular"));
  const auto surface = surfaceLightByName(specular);
  if (!surface) return root.error("specular", "\"included\" or \"removed\"");
  CUTIS_TRY(discrepancy, root.boolean("discrepancy", false));
  record.surface = *surface;
  record.discrepancy = discrepancy;
  CUTIS_CHECK(validate(record, profile, place));
  return record;
}

}  // namespace cutis
