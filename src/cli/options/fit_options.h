#pragma once

// Options of a fit, shared by the commands that fit.

#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "core/base/result.h"
#include "core/fit/fit_options.h"
#include "core/skin/profile/profile.h"
#include "src/app/open/source.h"
#include "src/cli/options/measurement_options.h"
#include "src/cli/options/option_values.h"

namespace cutis {

// The texts as they were given; empty: not given.
struct FitCommandOptions {
  std::string method;
  std::string profile;
  std::string rig;
  std::string lights;
  std::string layer;
  std::string exposure;
  std::string noise;
  std::string prior;
  std::vector<std::string> fixed;
  bool shading = false;
  std::string free;
  std::string discrepancy;
  std::string weights;
  MeasurementOptions measurement;
};

void addFitOptions(CLI::App& command, FitCommandOptions& options);

// The first option that was given, "--rig"; empty if none was.
std::string firstGiven(const FitCommandOptions& options);

// What can be said of the options before the profile is known.
struct FitRequest {
  std::string profile;
  std::string methodName;
  SourceOptions source;
  MeasurementSetting measurement;
  bool chooseExposure = true;    // for an image
  bool exposureIsGiven = false;  // whether by a number or by `auto`
  FitOptions options;
  std::string priorFile;
  std::vector<Assignment> fixed;
  std::string weightsFile;
};
Result<FitRequest> parseFitOptions(const FitCommandOptions& options);

// Adds the prior and the fixed parameters, both checked against the profile, and the network.
Status completeFitOptions(const FitRequest& request, const Profile& profile, FitOptions& options);

// Files that a fit reads beside its source.
std::vector<std::string> filesRead(const FitRequest& request);

}  // namespace cutis
