// Writing of src/files/network_file.h.

#include <array>
#include <cassert>
#include <charconv>
#include <cstdint>
#include <limits>
#include <span>

#include <nlohmann/json.hpp>

#include "src/files/atomic_write.h"
#include "src/files/network_file.h"

namespace cutis {
namespace {

using Json = nlohmann::ordered_json;

std::string shortest(float value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  assert(end.ec == std::errc());
  const std::string text(buffer.data(), end.ptr);
  // Without a point it would be read as a whole number, which has no negative zero.
  return text == "-0" ? "-0.0" : text;
}

std::string listOf(std::span<const float> values) {
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += ',';
    text += shortest(values[i]);
  }
  return text + "]";
}

// Of any column of doubles.
template <typename Column>
std::string rounded(const Column& values) {
  std::vector<float> floats;
  for (const double value : values)
    floats.push_back(static_cast<float>(value));
  return listOf(floats);
}

std::string jsonText(std::string_view text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::int64_t seedOf(std::uint64_t seed) {
  assert(seed <= std::uint64_t{std::numeric_limits<std::int32_t>::max()});
  return static_cast<std::int64_t>(seed);
}

// What the options of both networks have in common.
template <typename Options>
Json trainedJson(const Options& options) {
  const TrainerOptions& trainer = options.trainer;
  return {{"hidden", options.hidden},
          {"activation", activationName(options.activation)},
          {"people",
           {{"count", options.people.count},
            {"face_share", options.people.faceShare},
            {"seed", seedOf(options.people.seed)}}},
          {"trainer",
           {{"rate", trainer.rate},
            {"weight_decay", trainer.weightDecay},
            {"warm_up", trainer.warmUp},
            {"epochs", trainer.epochs},
            {"batch", trainer.batch},
            {"held_out_share", trainer.heldOutShare},
            {"patience", trainer.patience},
            {"seed", seedOf(trainer.seed)}}}};
}

std::string axesText(const ParameterAxes& axes) {
  Json list = Json::array();
  for (const ParameterAxis& axis : axes) {
    list.push_back(
        {{"maximum", axis.maximum}, {"samples", axis.samples}, {"exponent", axis.exponent}});
  }
  return list.dump();
}

std::string layersText(const DenseNetwork& network) {
  std::string text;
  for (const DenseLayer& layer : network.layers) {
    text += text.empty() ? "[\n" : ",\n";
    text += "{\"inputs\":" + std::to_string(layer.inputs) +
            ",\"outputs\":" + std::to_string(layer.outputs) +
            ",\"activation\":" + jsonText(activationName(layer.activation)) +
            ",\n\"weights\":" + listOf(layer.weights) + ",\n\"bias\":" + listOf(layer.bias) + "}";
  }
  return text + "]";
}

std::string componentsText(const Eigen::MatrixXd& components) {
  std::string text;
  for (Eigen::Index k = 0; k < components.cols(); ++k) {
    text += (text.empty() ? "[\n" : ",\n") + rounded(components.col(k));
  }
  return text + "]";
}

std::string spectraText(const NetworkFile& file) {
  Json trained = trainedJson(file.spectraOptions);
  trained["components"] = file.spectraOptions.components;
  trained["truncation_error"] = file.spectraOptions.truncationError;
  return "{\n\"trained\":" + trained.dump() + ",\n\"profile\":" + jsonText(file.spectra.profile) +
         ",\n\"axes\":" + axesText(file.spectra.axes) +
         ",\n\"mean\":" + rounded(file.spectra.mean) +
         ",\n\"components\":" + componentsText(file.spectra.components) +
         ",\n\"layers\":" + layersText(file.spectra.network) + "}";
}

std::string chromophoresText(const NetworkFile& file) {
  Json trained = trainedJson(file.chromophoreOptions);
  const NoiseModel& noise = file.chromophoreOptions.noise;
  trained["noise"] = {noise.read, noise.proportional};
  const ChromophoreNetwork& network = file.chromophores;
  return "{\n\"trained\":" + trained.dump() + ",\n\"profile\":" + jsonText(network.profile) +
         ",\n\"channels\":" + jsonText(network.channels) + ",\n\"axes\":" + axesText(network.axes) +
         ",\n\"layers\":" + layersText(network.network) + "}";
}

}  // namespace

std::string networkText(const NetworkFile& file) {
  return "{\n\"cutis_network\":1,\n\"rig\":" + jsonText(file.rig) +
         ",\n\"profile\":" + jsonText(file.profile) + ",\n\"command\":" + jsonText(file.command) +
         ",\n\"spectra_nn\":" + spectraText(file) + ",\n\"chrom_nn\":" + chromophoresText(file) +
         "\n}\n";
}

Status writeNetworks(const std::string& path, const NetworkFile& file) {
  return writeTextAtomically(path, networkText(file));
}

}  // namespace cutis
