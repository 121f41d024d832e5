#pragma once

// What networks of a size cost and how good they are.

#include <cstddef>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "src/app/training/network_errors.h"
#include "src/app/training/network_training.h"

namespace cutis {

struct SizeFigures {
  std::size_t weights = 0;         // of both networks
  std::size_t workPerPixel = 0;    // multiply-adds, from channels to the rig's channels
  double encodeNanoseconds = 0.0;  // a pixel, from channels to parameters
  double decodeNanoseconds = 0.0;  // a pixel, from channels to the rig's channels
  NetworkErrors errors;
  double trainingSeconds = 0.0;
};

// Trains both networks with the hidden layers that `training` has and measures them. Times are of
// one core, the least of several runs. Errors: those of trainNetworks() and measureNetworks().
Result<SizeFigures> studySize(const SkinModel& model, const Rig& rig,
                              const NetworkTraining& training, const JobContext& context);

}  // namespace cutis
