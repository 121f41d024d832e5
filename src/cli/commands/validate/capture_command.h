#pragma once  // internal to src/cli/commands/validate

// validate --capture: spectra that are photographed by arithmetic and fitted, beside Wiener
// estimates.

#include <memory>
#include <string>
#include <vector>

#include "core/skin/model/skin_model.h"
#include "core/spectra/measured_spectra.h"
#include "src/cli/command.h"
#include "src/cli/options/measurement_options.h"

namespace cutis {

// The texts as they were given; empty: not given.
struct CaptureOptions {
  std::string rig;  // empty: nothing is photographed
  std::string noise;
  std::string table;
  std::string halvings;
  std::string folds;
  std::string seed;
};

void addCaptureOptions(CLI::App& command, CaptureOptions& options);
// A usage error where one of them goes with --capture, and that is missing.
Status requireCapture(const CaptureOptions& options);

// One of the files of spectra.
struct CapturedFile {
  std::string path;
  MeasuredSpectra spectra;
};

struct CaptureRequest {
  std::vector<CapturedFile> files;
  std::vector<std::string> profileFiles;  // as they were named
  std::vector<std::shared_ptr<const SkinModel>> models;
  MeasurementOptions measurement;
  std::string plot;  // empty: none
};

// Prints the tables; writes table and plot where they are asked for. Nothing is computed before all
// options and outputs were looked at.
Status runCaptureCommand(const CaptureOptions& options, const CaptureRequest& request,
                         Session& session);

}  // namespace cutis
