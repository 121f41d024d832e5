#include "src/files/networks/network_parts.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cutis {
namespace {

using Json = nlohmann::ordered_json;

// The largest float, as its shortest text reads in double precision.
constexpr double kMostFloat = 3.4028235e38;

std::string shortest(float value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  assert(end.ec == std::errc());
  const std::string text(buffer.data(), end.ptr);
  // Without a point it would be read as a whole number, which has no negative zero.
  return text == "-0" ? "-0.0" : text;
}

std::int64_t signedSeed(std::uint64_t seed) {
  assert(seed <= std::uint64_t{std::numeric_limits<std::int32_t>::max()});
  return static_cast<std::int64_t>(seed);
}

// What both have in common.
template <typename Options>
Json trainedJson(const Options& options) {
  const TrainerOptions& trainer = options.trainer;
  return {{"hidden", options.hidden},
          {"activation", activationName(options.activation)},
          {"people",
           {{"count", options.people.count},
            {"face_share", options.people.faceShare},
            {"seed", signedSeed(options.people.seed)}}},
          {"trainer",
           {{"rate", trainer.rate},
            {"weight_decay", trainer.weightDecay},
            {"warm_up", trainer.warmUp},
            {"epochs", trainer.epochs},
            {"batch", trainer.batch},
            {"held_out_share", trainer.heldOutShare},
            {"patience", trainer.patience},
            {"seed", signedSeed(trainer.seed)}}}};
}

Result<DenseLayer> parseLayer(const JsonValue& object) {
  if (!object.isObject()) return object.error("an object");
  CUTIS_CHECK(object.allowOnly({"inputs", "outputs", "activation", "weights", "bias"}));
  CUTIS_TRY(inputs, wholeNumber(object, "inputs", 1, kMaximumUnits));
  CUTIS_TRY(outputs, wholeNumber(object, "outputs", 1, kMaximumUnits));
  CUTIS_TRY(activation, activationOf(object));
  CUTIS_TRY(weights, floats(object, "weights",
                            static_cast<std::size_t>(inputs) * static_cast<std::size_t>(outputs)));
  CUTIS_TRY(bias, floats(object, "bias", static_cast<std::size_t>(outputs)));
  return DenseLayer{inputs, outputs, activation, std::move(weights), std::move(bias)};
}

}  // namespace

std::string floatsText(std::span<const float> values) {
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += ',';
    text += shortest(values[i]);
  }
  return text + "]";
}

std::string jsonText(const Json& text) {
  return text.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string layersText(const DenseNetwork& network) {
  std::string text;
  for (const DenseLayer& layer : network.layers) {
    text += text.empty() ? "[\n" : ",\n";
    text += "{\"inputs\":" + std::to_string(layer.inputs) +
            ",\"outputs\":" + std::to_string(layer.outputs) +
            ",\"activation\":" + jsonText(activationName(layer.activation)) +
            ",\n\"weights\":" + floatsText(layer.weights) +
            ",\n\"bias\":" + floatsText(layer.bias) + "}";
  }
  return text + "]";
}

std::string optionsText(const SpectraNetworkOptions& options) {
  Json trained = trainedJson(options);
  trained["components"] = options.components;
  trained["truncation_error"] = options.truncationError;
  return trained.dump();
}

std::string optionsText(const ChromophoreNetworkOptions& options) {
  Json trained = trainedJson(options);
  trained["noise"] = {options.noise.read, options.noise.proportional};
  return trained.dump();
}

Result<int> wholeNumber(const JsonValue& object, const std::string& key, int least, int most) {
  CUTIS_TRY(value, object.integer(key));
  if (value < least || value > most) {
    return object.error(
        key, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return value;
}

Result<std::vector<float>> asFloats(const JsonValue& list, std::size_t count) {
  CUTIS_TRY(numbers, list.asNumbers(count));
  constexpr double kMost = std::numeric_limits<float>::max();
  std::vector<float> values;
  values.reserve(count);
  for (const double number : numbers) {
    if (std::abs(number) > kMostFloat) return list.error("a list of numbers that fit a float");
    values.push_back(static_cast<float>(std::clamp(number, -kMost, kMost)));
  }
  return values;
}

Result<std::vector<float>> floats(const JsonValue& object, const std::string& key,
                                  std::size_t count) {
  CUTIS_TRY(list, object.list(key));
  return asFloats(list, count);
}

Result<Activation> activationOf(const JsonValue& object) {
  CUTIS_TRY(name, object.text("activation"));
  if (const auto activation = activationByName(name)) return *activation;
  return object.error("activation", "linear, relu, sigmoid or squareplus");
}

Result<DenseNetwork> parseLayers(const JsonValue& object, const std::string& key) {
  CUTIS_TRY(layers, object.array(key));
  if (layers.empty() || layers.size() > std::size_t{kMaximumLayers}) {
    return object.error(key, "a list of 1 to " + std::to_string(kMaximumLayers) + " layers");
  }
  DenseNetwork network;
  for (const JsonValue& element : layers) {
    CUTIS_TRY(layer, parseLayer(element));
    network.layers.push_back(std::move(layer));
  }
  return network;
}

}  // namespace cutis
