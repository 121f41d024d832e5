#pragma once

// The state of a training of networks (core/neural/dense/trainer.h) that was interrupted:
//
//   cutis_training   1
//   command          what was asked for, as a weights file records it
//   identity         of everything that changes the result; equal identities, equal results
//   spectra_nn       {steps, best_epoch, best_error, curve, network, best, first_moment,
//                    second_moment}; curve: [rate, trained error, held-out error] of each epoch;
//                    networks: layers as in a weights file (src/files/networks/network_file.h)
//   chrom_nn         the same; missing while SpectraNN is trained
//
// Floats and numbers are written so that they read back as the same: who goes on from a file ends
// with the same bytes as who was never interrupted.

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/neural/dense/trainer.h"

namespace cutis {

// Fresh, or what a cancelled training left behind.
struct NetworkTrainingState {
  TrainingState spectra;
  TrainingState chromophores;
};

struct TrainingFile {
  std::string command;
  std::string identity;
  NetworkTrainingState state;
};

// Preconditions: SpectraNN has done a whole epoch.
std::string trainingText(const TrainingFile& file);
Status writeTraining(const std::filesystem::path& path, const TrainingFile& file);

// Each network is sound and its numbers are finite; whether the state fits a training is for the
// trainer to say.
Result<TrainingFile> parseTraining(std::string_view text, const std::string& place);
Result<TrainingFile> readTraining(const std::filesystem::path& path);

}  // namespace cutis
