#pragma once  // internal to src/cli/commands

// From a path and options to fitted maps, as `fit` and `apply` need them.

#include <string>

#include "core/base/result.h"
#include "src/app/open/source_fit.h"
#include "src/cli/command.h"
#include "src/cli/options/fit_options.h"

namespace cutis {

struct FittedPath {
  FittedSource fitted;
  std::string profileJson;  // the text of the profile
};

// Notes what there is to say about the fit. Reports to the first `share` of the session's progress.
Result<FittedPath> openAndFit(const std::string& path, const FitRequest& request,
                              const Session& session, double share);

}  // namespace cutis
