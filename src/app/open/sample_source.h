#pragma once

// The embedded sample, ready to be fitted with any profile.

#include <memory>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/model/skin_model.h"
#include "src/app/engine.h"
#include "src/app/open/source.h"

namespace cutis {

// The same photographs whatever they are fitted with: skin of the default profile. About 0.3 s.
Result<Source> openSampleFor(const SkinModel& model, Engine& engine,
                             const std::shared_ptr<TileStore>& store, const JobContext& context);

}  // namespace cutis
