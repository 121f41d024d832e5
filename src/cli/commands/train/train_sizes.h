#pragma once  // internal to src/cli/commands/train

// What networks of several sizes cost and how good they are, as a table.

#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "src/app/training/network_training.h"

namespace cutis {

// A list of sizes, "16,16;default;64,64,64": hidden layers of both networks, or those that
// `training` has. Trains and measures each and returns a table with a row for each. Times are of
// one core, the least of several runs.
Result<std::string> sizesTable(const std::string& sizes, const SkinModel& model, const Rig& rig,
                               const NetworkTraining& training, const JobContext& context);

// Whether the list can be understood, before any work is done.
Status checkSizes(const std::string& sizes);

}  // namespace cutis
