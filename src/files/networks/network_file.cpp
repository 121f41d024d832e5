// Reading of src/files/networks/network_file.h.

#include "src/files/networks/network_file.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>

#include "core/base/echoed_text.h"
#include "core/skin/profile/profile_signature.h"
#include "src/files/io/json_file.h"
#include "src/files/io/suggestion.h"
#include "src/files/io/text_file.h"
#include "src/files/networks/network_parts.h"
#include "src/files/resources.h"

namespace cutis {
namespace {

constexpr int kNewestNetwork = 1;
constexpr char kNetworksFolder[] = "networks";
constexpr char kSuffix[] = ".json";
// The largest networks allowed have some 25 MB.
constexpr std::size_t kMostBytes = std::size_t{32} << 20;

Result<std::uint64_t> seedOf(const JsonValue& object) {
  CUTIS_TRY(seed, wholeNumber(object, "seed", 0, std::numeric_limits<int>::max()));
  return static_cast<std::uint64_t>(seed);
}

Result<ParameterAxes> parseAxes(const JsonValue& object) {
  CUTIS_TRY(elements, object.array("axes"));
  ParameterAxes axes;
  if (elements.size() != axes.size()) return object.error("axes", "a list of five axes");
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (!elements[k].isObject()) return elements[k].error("an object");
    CUTIS_CHECK(elements[k].allowOnly({"maximum", "samples", "exponent"}));
    CUTIS_TRY(maximum, elements[k].number("maximum"));
    CUTIS_TRY(samples, elements[k].integer("samples"));
    CUTIS_TRY(exponent, elements[k].integer("exponent"));
    axes[k] = {maximum, samples, exponent};
  }
  return axes;
}

Result<std::vector<int>> parseHidden(const JsonValue& object) {
  CUTIS_TRY(elements, object.array("hidden"));
  if (elements.empty() || elements.size() > std::size_t{kMaximumLayers}) {
    return object.error("hidden", "a list of 1 to " + std::to_string(kMaximumLayers) + " sizes");
  }
  std::vector<int> hidden;
  for (const JsonValue& element : elements) {
    CUTIS_TRY(units, element.asNumber());
    if (!(units >= 1 && units <= kMaximumUnits && units == std::floor(units))) {
      return element.error("a whole number from 1 to " + std::to_string(kMaximumUnits));
    }
    hidden.push_back(static_cast<int>(units));
  }
  return hidden;
}

Result<TrainingPeople> parsePeople(const JsonValue& trained) {
  CUTIS_TRY(object, trained.object("people"));
  CUTIS_CHECK(object.allowOnly({"count", "face_share", "seed"}));
  CUTIS_TRY(count, object.integer("count"));
  CUTIS_TRY(faceShare, object.number("face_share"));
  CUTIS_TRY(seed, seedOf(object));
  return TrainingPeople{faceShare, count, seed};
}

Result<TrainerOptions> parseTrainer(const JsonValue& trained) {
  CUTIS_TRY(object, trained.object("trainer"));
  CUTIS_CHECK(object.allowOnly({"rate", "weight_decay", "warm_up", "epochs", "batch",
                                "held_out_share", "patience", "seed"}));
  CUTIS_TRY(rate, object.number("rate"));
  CUTIS_TRY(weightDecay, object.number("weight_decay"));
  CUTIS_TRY(warmUp, object.number("warm_up"));
  CUTIS_TRY(epochs, object.integer("epochs"));
  CUTIS_TRY(batch, object.integer("batch"));
  CUTIS_TRY(heldOutShare, object.number("held_out_share"));
  CUTIS_TRY(patience, object.integer("patience"));
  CUTIS_TRY(seed, seedOf(object));
  return TrainerOptions{rate, weightDecay, warmUp, epochs, batch, heldOutShare, patience, seed};
}

// What the options of both networks have in common.
template <typename Options>
Status parseTrained(const JsonValue& trained, Options& options) {
  CUTIS_TRY(hidden, parseHidden(trained));
  CUTIS_TRY(activation, activationOf(trained));
  CUTIS_TRY(people, parsePeople(trained));
  CUTIS_TRY(trainer, parseTrainer(trained));
  options.hidden = hidden;
  options.activation = activation;
  options.people = people;
  options.trainer = trainer;
  return validate(trainer, trained.file());
}

Status parseSpectraOptions(const JsonValue& object, SpectraNetworkOptions& options) {
  CUTIS_TRY(trained, object.object("trained"));
  CUTIS_CHECK(trained.allowOnly(
      {"hidden", "activation", "people", "trainer", "components", "truncation_error"}));
  CUTIS_CHECK(parseTrained(trained, options));
  CUTIS_TRY(components, wholeNumber(trained, "components", 0, kMaximumComponents));
  CUTIS_TRY(truncationError, trained.number("truncation_error"));
  options.components = components;
  options.truncationError = truncationError;
  return {};
}

Status parseChromophoreOptions(const JsonValue& object, ChromophoreNetworkOptions& options) {
  CUTIS_TRY(trained, object.object("trained"));
  CUTIS_CHECK(trained.allowOnly({"hidden", "activation", "people", "trainer", "noise"}));
  CUTIS_CHECK(parseTrained(trained, options));
  CUTIS_TRY(list, trained.list("noise"));
  CUTIS_TRY(noise, list.asNumbers(2));
  if (noise[0] < 0.0 || noise[1] < 0.0) return trained.error("noise", "two numbers from 0");
  options.noise = {noise[0], noise[1]};
  return {};
}

Result<Eigen::MatrixXd> parseComponents(const JsonValue& object) {
  CUTIS_TRY(columns, object.array("components"));
  if (columns.empty() || columns.size() > std::size_t{kMaximumComponents}) {
    return object.error("components",
                        "a list of 1 to " + std::to_string(kMaximumComponents) + " components");
  }
  Eigen::MatrixXd components(kSampleCount, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    CUTIS_TRY(values, asFloats(columns[k], kSampleCount));
    components.col(static_cast<Eigen::Index>(k)) =
        Eigen::Map<const Eigen::VectorXf>(values.data(), kSampleCount).cast<double>();
  }
  return components;
}

Result<Signature> parseSignature(const JsonValue& object, const std::string& key) {
  CUTIS_TRY(elements, object.array(key));
  return floats(object, key, elements.size());
}

Result<std::vector<std::string>> parseInputs(const JsonValue& object) {
  CUTIS_TRY(elements, object.array("inputs"));
  std::vector<std::string> names;
  for (const JsonValue& element : elements) {
    CUTIS_TRY(name, element.asText());
    names.push_back(name);
  }
  return names;
}

Result<SpectraNetwork> parseSpectraNetwork(const JsonValue& object) {
  SpectraNetwork network;
  CUTIS_TRY(profile, parseSignature(object, "profile"));
  CUTIS_TRY(axes, parseAxes(object));
  CUTIS_TRY(mean, floats(object, "mean", kSampleCount));
  CUTIS_TRY(components, parseComponents(object));
  CUTIS_TRY(layers, parseLayers(object, "layers"));
  network.profile = profile;
  network.axes = axes;
  network.mean = Eigen::Map<const Eigen::ArrayXf>(mean.data(), kSampleCount).cast<double>();
  network.components = std::move(components);
  network.network = std::move(layers);
  CUTIS_CHECK(validate(network, object.file() + ": spectra_nn"));
  return network;
}

Result<ChromophoreNetwork> parseChromophoreNetwork(const JsonValue& object) {
  ChromophoreNetwork network;
  CUTIS_TRY(profile, parseSignature(object, "profile"));
  CUTIS_TRY(inputs, parseInputs(object));
  CUTIS_TRY(channels, parseSignature(object, "channels"));
  CUTIS_TRY(axes, parseAxes(object));
  CUTIS_TRY(layers, parseLayers(object, "layers"));
  network.profile = profile;
  network.inputs = inputs;
  network.channels = channels;
  network.axes = axes;
  network.network = std::move(layers);
  CUTIS_CHECK(validate(network, object.file() + ": chrom_nn"));
  return network;
}

bool sameAxes(const ParameterAxes& a, const ParameterAxes& b) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k].maximum != b[k].maximum || a[k].exponent != b[k].exponent) return false;
  }
  return true;
}

Status parseBoth(const JsonValue& root, NetworkFile& file) {
  CUTIS_TRY(spectra, root.object("spectra_nn"));
  CUTIS_CHECK(spectra.allowOnly({"trained", "profile", "axes", "mean", "components", "layers"}));
  CUTIS_CHECK(parseSpectraOptions(spectra, file.spectraOptions));
  CUTIS_TRY(spectraNetwork, parseSpectraNetwork(spectra));
  CUTIS_TRY(chromophores, root.object("chrom_nn"));
  CUTIS_CHECK(
      chromophores.allowOnly({"trained", "profile", "inputs", "channels", "axes", "layers"}));
  CUTIS_CHECK(parseChromophoreOptions(chromophores, file.chromophoreOptions));
  CUTIS_TRY(chromophoreNetwork, parseChromophoreNetwork(chromophores));
  file.spectra = std::move(spectraNetwork);
  file.chromophores = std::move(chromophoreNetwork);
  if (alike(file.spectra.profile, file.chromophores.profile) &&
      sameAxes(file.spectra.axes, file.chromophores.axes)) {
    return {};
  }
  return inputError(root.file(),
                    "spectra_nn and chrom_nn are of different profiles; train them again together");
}

}  // namespace

Result<NetworkFile> parseNetworks(std::string_view text, const std::string& place) {
  CUTIS_TRY(root, parseJson(text, place));
  CUTIS_CHECK(checkVersion(root, "cutis_network", kNewestNetwork));
  CUTIS_CHECK(
      root.allowOnly({"cutis_network", "rig", "profile", "command", "spectra_nn", "chrom_nn"}));
  NetworkFile file;
  CUTIS_TRY(rig, root.text("rig"));
  CUTIS_TRY(profile, root.text("profile"));
  CUTIS_TRY(command, root.text("command"));
  file.rig = rig;
  file.profile = profile;
  file.command = command;
  CUTIS_CHECK(parseBoth(root, file));
  return file;
}

Result<NetworkFile> readNetworks(const std::string& path) {
  CUTIS_TRY(text, readTextFile(path, kMostBytes));
  return parseNetworks(text, path);
}

std::vector<std::string> builtInNetworkNames() {
  return resourceStems(kNetworksFolder, kSuffix);
}

Result<NetworkFile> builtInNetworks(const std::string& name) {
  const auto text = resource(std::string(kNetworksFolder) + "/" + name + kSuffix);
  if (!text) return inputError(name, "no networks of this name are built in");
  return parseNetworks(*text, "built-in networks " + name);
}

Result<NetworkFile> loadNetworks(const std::string& nameOrPath, const Profile& profile,
                                 const std::string& place) {
  const Signature wanted = signatureOf(profile);
  std::vector<std::string> known;
  for (const std::string& name : builtInNetworkNames()) {
    if (name == nameOrPath) return builtInNetworks(name);
    CUTIS_TRY(networks, builtInNetworks(name));
    if (!alike(networks.spectra.profile, wanted)) continue;
    known.push_back(name.substr(0, name.size() - networks.profile.size() - 1));
    if (known.back() == nameOrPath) return networks;
  }
  std::error_code ignored;
  if (nameOrPath.find('/') != std::string::npos || nameOrPath.ends_with(".json") ||
      std::filesystem::exists(nameOrPath, ignored)) {
    return readNetworks(nameOrPath);
  }
  const std::string way =
      known.empty() ? "none are built in for it" : suggestName(nameOrPath, known);
  return inputError(place, "unknown networks " + inQuotes(nameOrPath) + " of profile " +
                               inQuotes(profile.name) + "; " + way +
                               ", or name a file that train has written");
}

}  // namespace cutis
