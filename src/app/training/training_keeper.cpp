#include "src/app/training/training_keeper.h"

#include <system_error>
#include <utility>

#include "core/base/echoed_text.h"

namespace cutis {
namespace {

constexpr auto kBetweenWrites = std::chrono::seconds(5);

}  // namespace

TrainingKeeper::TrainingKeeper(std::filesystem::path path, std::string command,
                               std::string identity)
    : path_(std::move(path)), command_(std::move(command)), identity_(std::move(identity)) {}

Result<NetworkTrainingState> TrainingKeeper::load() {
  std::error_code ignored;
  if (path_.empty() || !std::filesystem::exists(path_, ignored)) return NetworkTrainingState{};
  CUTIS_TRY(file, readTraining(path_));
  if (file.command != command_) {
    return inputError(path_.string(), "this is the state of another training, " +
                                          inQuotes(file.command) +
                                          "; repeat that command, or name another file");
  }
  if (file.identity != identity_) {
    return inputError(path_.string(),
                      "the rig, the profile or the program has changed since this training was "
                      "interrupted; delete the file to start again");
  }
  resumed_ = true;
  return std::move(file.state);
}

Failure TrainingKeeper::explained(const Failure& failure) const {
  const auto* error = std::get_if<Error>(&failure);
  if (!resumed_ || error == nullptr || error->kind != ErrorKind::input) return failure;
  return inputError(path_.string(),
                    "no training continues from this state; delete it to start again");
}

void TrainingKeeper::keep(const NetworkTrainingState& state, const JobContext& context) {
  if (path_.empty()) return;
  if (written_ && std::chrono::steady_clock::now() - *written_ < kBetweenWrites) return;
  const Status written = save(state);
  if (written.failed()) context.say(written.error().text());
}

Status TrainingKeeper::save(const NetworkTrainingState& state) {
  written_ = std::chrono::steady_clock::now();
  if (path_.empty() || state.spectra.curve.empty()) return {};
  return writeTraining(path_, {command_, identity_, state});
}

Status TrainingKeeper::remove() const {
  std::error_code error;
  if (!path_.empty()) std::filesystem::remove(path_, error);
  if (!error) return {};
  return resourceError(path_.string(),
                       "the state of the finished training could not be deleted; "
                       "delete it yourself");
}

}  // namespace cutis
