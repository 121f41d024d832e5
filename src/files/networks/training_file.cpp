#include "src/files/networks/training_file.h"

#include <cmath>
#include <utility>

#include "src/files/io/atomic_write.h"
#include "src/files/io/text_file.h"
#include "src/files/networks/network_parts.h"

namespace cutis {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kNewestTraining = 1;
// The largest networks allowed have some 100 MB here.
constexpr std::size_t kMostTrainingBytes = std::size_t{128} << 20;
constexpr int kMostEpochs = 100'000;
// Whole numbers up to here are exact in double precision.
constexpr double kMostSteps = 9e15;

std::string stateText(const TrainingState& state) {
  Json curve = Json::array();
  for (const TrainingEpoch& epoch : state.curve)
    curve.push_back({epoch.rate, epoch.trainedError, epoch.heldOutError});
  return "{\n\"steps\":" + std::to_string(state.steps) +
         ",\"best_epoch\":" + std::to_string(state.bestEpoch) +
         ",\"best_error\":" + Json(state.bestError).dump() + ",\n\"curve\":" + curve.dump() +
         ",\n\"network\":" + layersText(state.network) + ",\n\"best\":" + layersText(state.best) +
         ",\n\"first_moment\":" + floatsText(state.firstMoment) +
         ",\n\"second_moment\":" + floatsText(state.secondMoment) + "}";
}

Result<std::vector<TrainingEpoch>> parseCurve(const JsonValue& object) {
  CUTIS_TRY(elements, object.array("curve"));
  if (elements.empty() || elements.size() > std::size_t{kMostEpochs}) {
    return object.error("curve", "a list of 1 to " + std::to_string(kMostEpochs) + " epochs");
  }
  std::vector<TrainingEpoch> curve;
  for (const JsonValue& element : elements) {
    CUTIS_TRY(numbers, element.asNumbers(3));
    curve.push_back({static_cast<int>(curve.size()) + 1, numbers[0], numbers[1], numbers[2]});
  }
  return curve;
}

Result<std::vector<float>> parseMoment(const JsonValue& object, const std::string& key) {
  CUTIS_TRY(elements, object.array(key));
  return floats(object, key, elements.size());
}

Result<DenseNetwork> parseNetwork(const JsonValue& object, const std::string& key) {
  CUTIS_TRY(network, parseLayers(object, key));
  CUTIS_CHECK(validate(network, object.file() + ": " + key));
  return network;
}

Result<TrainingState> parseState(const JsonValue& object) {
  CUTIS_CHECK(object.allowOnly({"steps", "best_epoch", "best_error", "curve", "network", "best",
                                "first_moment", "second_moment"}));
  TrainingState state;
  CUTIS_TRY(steps, object.number("steps"));
  if (!(steps >= 1.0 && steps <= kMostSteps && steps == std::floor(steps))) {
    return object.error("steps", "a whole number from 1");
  }
  CUTIS_TRY(bestEpoch, wholeNumber(object, "best_epoch", 1, kMostEpochs));
  CUTIS_TRY(bestError, object.number("best_error"));
  CUTIS_TRY(curve, parseCurve(object));
  CUTIS_TRY(network, parseNetwork(object, "network"));
  CUTIS_TRY(best, parseNetwork(object, "best"));
  CUTIS_TRY(firstMoment, parseMoment(object, "first_moment"));
  CUTIS_TRY(secondMoment, parseMoment(object, "second_moment"));
  state.steps = static_cast<std::int64_t>(steps);
  state.bestEpoch = bestEpoch;
  state.bestError = bestError;
  state.curve = std::move(curve);
  state.network = std::move(network);
  state.best = std::move(best);
  state.firstMoment = std::move(firstMoment);
  state.secondMoment = std::move(secondMoment);
  return state;
}

}  // namespace

std::string trainingText(const TrainingFile& file) {
  std::string text = "{\n\"cutis_training\":1,\n\"command\":" + jsonText(file.command) +
                     ",\n\"identity\":" + jsonText(file.identity) +
                     ",\n\"spectra_nn\":" + stateText(file.state.spectra);
  if (!file.state.chromophores.curve.empty()) {
    text += ",\n\"chrom_nn\":" + stateText(file.state.chromophores);
  }
  return text + "\n}\n";
}

Status writeTraining(const std::filesystem::path& path, const TrainingFile& file) {
  return writeTextAtomically(path, trainingText(file));
}

Result<TrainingFile> parseTraining(std::string_view text, const std::string& place) {
  CUTIS_TRY(root, parseJson(text, place));
  CUTIS_CHECK(checkVersion(root, "cutis_training", kNewestTraining));
  CUTIS_CHECK(root.allowOnly({"cutis_training", "command", "identity", "spectra_nn", "chrom_nn"}));
  TrainingFile file;
  CUTIS_TRY(command, root.text("command"));
  CUTIS_TRY(identity, root.text("identity"));
  CUTIS_TRY(spectra, root.object("spectra_nn"));
  CUTIS_TRY(spectraState, parseState(spectra));
  file.command = command;
  file.identity = identity;
  file.state.spectra = std::move(spectraState);
  if (!root.has("chrom_nn")) return file;
  CUTIS_TRY(chromophores, root.object("chrom_nn"));
  CUTIS_TRY(chromophoreState, parseState(chromophores));
  file.state.chromophores = std::move(chromophoreState);
  return file;
}

Result<TrainingFile> readTraining(const std::filesystem::path& path) {
  CUTIS_TRY(text, readTextFile(path, kMostTrainingBytes));
  return parseTraining(text, path.string());
}

}  // namespace cutis
