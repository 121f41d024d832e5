#pragma once

// From a path to fitted maps, as `fit` and `apply` need them.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/analyse/constants_summary.h"
#include "core/analyse/gamut.h"
#include "core/base/result.h"
#include "core/fit/fit_run.h"
#include "src/app/open/source.h"
#include "src/cli/command.h"
#include "src/cli/options/fit_options.h"
#include "src/images/maps/maps_file.h"

namespace cutis {

struct FitSeconds {
  double load = 0.0;     // reading the source
  double prepare = 0.0;  // nodes, tables, exposure
  double fit = 0.0;
  double write = 0.0;
};

struct FittedSource {
  std::shared_ptr<const SkinModel> model;
  Source source;
  FitPlanes planes;
  FitStatistics statistics;
  GamutStatistics gamut;
  std::vector<ConstantSummary> constants;  // one for each that is free
  std::optional<double> outsideDiffusion;  // share of the pixels; none by radiative transfer
  int nodes = 0;
  double nodeRms = 0.0;    // error of a channel summed at the nodes …
  double nodeWorst = 0.0;  // … and the worst of those looked at
  FitSeconds seconds;
};

// Reports to the first `share` of the session's progress.
Result<FittedSource> fitSource(const std::string& path, const FitRequest& request,
                               const Session& session, double share);

// The file that a fit writes; planes are shared.
Result<MapsFile> mapsFileOf(const FittedSource& fitted, const FitRequest& request);

}  // namespace cutis
