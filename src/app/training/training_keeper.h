#pragma once

// Keeps the state of a training in a file while it runs, so that it can be interrupted and gone on
// with.
//
// Used from the thread that trains.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/files/networks/training_file.h"

namespace cutis {

class TrainingKeeper {
 public:
  // An empty path keeps nothing. command, identity: as in TrainingFile.
  TrainingKeeper(std::filesystem::path path, std::string command, std::string identity);

  // What an interrupted training of the same command left behind, or a fresh state. Fails if the
  // file is of another training or damaged.
  Result<NetworkTrainingState> load();

  // An error of the training itself: of a state that was loaded, with its file and what to do.
  Failure explained(const Failure& failure) const;

  // After each epoch: writes the first, and then if the last time was some seconds ago. A failure
  // is a notice and does not stop the training.
  void keep(const NetworkTrainingState& state, const JobContext& context);
  // Writes now, where an epoch was done.
  Status save(const NetworkTrainingState& state);
  // The training is over, its weights are written: takes the file away.
  Status remove() const;

 private:
  std::filesystem::path path_;
  std::string command_;
  std::string identity_;
  std::optional<std::chrono::steady_clock::time_point> written_;
  bool resumed_ = false;
};

}  // namespace cutis
