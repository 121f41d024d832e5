#pragma once

// From a source to fitted maps, for window and command line alike: exposure, solver, fit, and what
// there is to say about it.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/analyse/constants_summary.h"
#include "core/analyse/gamut.h"
#include "core/analyse/skin_likeness.h"
#include "core/base/job_context.h"
#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/fit/fit_run.h"
#include "src/app/engine.h"
#include "src/app/open/fit_remark.h"
#include "src/app/open/source.h"
#include "src/images/maps/maps_file.h"

namespace cutis {

struct SourceFitOptions {
  FitOptions fit;
  // An albedo texture is fitted at the exposure that brings most of it into the profile's range of
  // skin colours, as this method of fitting finds it, instead of at the source's own.
  bool chooseExposure = false;
};

struct SourceFitObserver {
  // The source as it is fitted, what fits it, and new maps that hold a first impression, which fill
  // from now on. From the thread that fits. Empty: there is no first impression.
  std::function<void(const std::shared_ptr<const Source>& source,
                     const std::shared_ptr<const PixelSolver>& solver, const ChromophoreMaps& maps)>
      begun;
  // More of the maps is final. From any thread; may be empty.
  std::function<void()> changed;
  // What somebody looks at now, in pixels. From any thread; may be empty.
  std::function<Rect()> view;
};

struct FitSeconds {
  double load = 0.0;     // reading the source
  double prepare = 0.0;  // nodes, tables, exposure
  double fit = 0.0;
  double write = 0.0;
};

struct FittedSource {
  std::shared_ptr<const SkinModel> model;
  std::shared_ptr<const Source> source;  // at the exposure of the fit
  FitPlanes planes;
  FitOptions options;  // as they suit the source
  FitStatistics statistics;
  GamutStatistics gamut;
  JudgedPixels pixels;
  std::vector<ConstantSummary> constants;  // one for each that is free
  std::optional<double> outsideDiffusion;  // share of the pixels; none by radiative transfer
  std::optional<ExposureChoice> exposure;  // where it was found automatically
  std::vector<FitRemark> remarks;
  int nodes = 0;
  double nodeRms = 0.0;    // error of a channel summed at the nodes …
  double nodeWorst = 0.0;  // … and the worst of those looked at
  FitSeconds seconds;      // load and write are left to the caller
};

// Precondition: the source is for this model. Cancelled if asked to stop. Errors: those of
// Engine::solver().
Result<FittedSource> fitSource(const std::shared_ptr<const SkinModel>& model,
                               const std::shared_ptr<const Source>& source,
                               const SourceFitOptions& options, Engine& engine,
                               const std::shared_ptr<TileStore>& store, const JobContext& context,
                               const SourceFitObserver& observer = {});

// The file that a fit is written as; planes are shared. profileJson: the text of the profile.
MapsFile mapsFileOf(const FittedSource& fitted, const std::string& profileJson);

}  // namespace cutis
