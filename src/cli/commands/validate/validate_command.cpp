// validate: profiles against measured spectra, or, with --capture, photographs of them.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "core/evaluate/validation.h"
#include "core/fit/spectra/spectra_fit.h"
#include "src/cli/command.h"
#include "src/cli/commands/validate/capture_command.h"
#include "src/cli/commands/validate/validation_plot.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/measurement_options.h"
#include "src/cli/output_check.h"
#include "src/cli/standard_output.h"
#include "src/cli/text_table.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/rig_file.h"
#include "src/files/spectra/measured_spectra_file.h"
#include "src/report/picture_file.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

constexpr char kRig[] = "albedo";
constexpr WavelengthRange kModelRange = {kFirstWavelengthNm, kLastWavelengthNm};
constexpr int kDecimals = 4;

struct ValidateCommand {
  std::vector<std::string> spectra;
  std::vector<std::string> profiles;
  std::string plot;
  MeasurementOptions measurement;
  CaptureOptions capture;
};

using DataSet = CapturedFile;

using Models = std::vector<std::shared_ptr<const SkinModel>>;

std::string stemOf(const std::string& path) {
  return fs::path(path).stem().string();
}

// What a file may be called everywhere.
std::string asFileName(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_' && c != '.';
      },
      '_');
  return text;
}

// "out/residuals.svg" → "out/residuals_leeds_skin2026.svg"
std::string plotPath(const std::string& plot, const std::string& data, const Profile& profile) {
  const fs::path path(plot);
  const std::string name = path.stem().string() + "_" + asFileName(stemOf(data)) + "_" +
                           asFileName(profile.name) + path.extension().string();
  return (path.parent_path() / name).string();
}

Status checkPlots(const ValidateCommand& command, const Models& models) {
  if (command.plot.empty()) return {};
  std::vector<std::string> inputs = command.spectra;
  inputs.insert(inputs.end(), command.profiles.begin(), command.profiles.end());
  std::vector<std::string> paths;
  for (const std::string& data : command.spectra) {
    for (const auto& model : models) {
      const std::string path = plotPath(command.plot, data, model->profile());
      if (std::find(paths.begin(), paths.end(), path) != paths.end()) {
        return usageError(path,
                          "two plots would have this name; validate files or profiles that "
                          "are called the same one at a time");
      }
      CUTIS_CHECK(checkNotInput(path, inputs));
      CUTIS_CHECK(checkDrawingOutput(path));
      paths.push_back(path);
    }
  }
  return {};
}

Result<Models> loadModels(const std::vector<std::string>& names, Session& session) {
  Models models;
  for (const std::string& name : names.empty() ? profileNames() : names) {
    CUTIS_TRY(model, session.engine.model(name, "--profile"));
    models.push_back(model);
  }
  return models;
}

Result<DataSet> readData(const std::string& path, const JobContext& context) {
  CUTIS_TRY(spectra, readMeasuredSpectra(path, kModelRange, kFewestWavelengths, context));
  const auto visible = static_cast<std::size_t>(
      std::count_if(spectra.wavelengthsNm.begin(), spectra.wavelengthsNm.end(),
                    [](double wavelength) { return kFittedRange.contains(wavelength); }));
  if (visible >= kFewestWavelengths) return DataSet{path, std::move(spectra)};
  return inputError(path, "too few wavelengths lie from 400 to 700 nm: " + std::to_string(visible) +
                              " where at least " + std::to_string(kFewestWavelengths) +
                              " are needed");
}

Status print(const std::string& text, const Session& session) {
  session.clearProgress();
  return printText(text, kTablesLost);
}

std::string legend() {
  return "RMSE of reflectance. Skin is fitted to 400-700 nm alone; what lies beyond is predicted "
         "from that fit.\nFrom colour: 400-700 nm as predicted from the colour under D65 (CIE "
         "1931) and the profile's prior.\n";
}

std::string rangeName(const WavelengthRange& range) {
  return formatNumber(range.fromNm) + "-" + formatNumber(range.toNm);
}

std::string headingOf(const DataSet& data, const MeasurementSetting& setting) {
  const std::size_t count = data.spectra.ids.size();
  return "\n" + fs::path(data.path).filename().string() + ": " + std::to_string(count) +
         (count == 1 ? " spectrum, " : " spectra, ") +
         rangeName({data.spectra.wavelengthsNm.front(), data.spectra.wavelengthsNm.back()}) +
         " nm, " + described(setting) + "\n";
}

TextTable tableFor(const MeasuredSpectra& spectra) {
  const auto nameOf = [&](const WavelengthRange& range) {
    return rangeName(measuredPart(spectra, range).value_or(range)) + " mean";
  };
  return TextTable({"profile", rangeName(kFittedRange) + " mean", "median", "95 % within", "max",
                    nameOf(kUltravioletRange), nameOf(kNearInfraredRange), "from colour median",
                    "mean"});
}

std::vector<std::string> rowOf(const std::string& profile, const ValidationFigures& figures) {
  std::vector<std::string> row = {profile};
  for (const double value :
       {figures.fitted.mean, figures.fitted.median, figures.fitted.within95, figures.fitted.most,
        figures.ultraviolet.mean, figures.nearInfrared.mean, figures.fromColor.median,
        figures.fromColor.mean}) {
    row.push_back(fixedNumber(value, kDecimals));
  }
  return row;
}

Status validateOn(const DataSet& data, const ValidateCommand& command, const Models& models,
                  const MeasurementSetting& setting, const Rig& rig, Session& session,
                  const JobContext& context) {
  TextTable table = tableFor(data.spectra);
  for (std::size_t m = 0; m < models.size(); ++m) {
    const Profile& profile = models[m]->profile();
    const auto total = static_cast<double>(models.size());
    const JobContext part =
        context.child(static_cast<double>(m) / total, static_cast<double>(m + 1) / total,
                      profile.name + " on " + stemOf(data.path));
    CUTIS_TRY(figures,
              validateModel(*models[m], data.spectra, geometryOf(setting, profile), rig, part));
    table.add(rowOf(profile.name, figures));
    if (command.plot.empty()) continue;
    CUTIS_CHECK(writeDrawing(plotPath(command.plot, data.path, profile),
                             validationPlot(figures, data.spectra.wavelengthsNm, profile.name,
                                            stemOf(data.path), described(setting))));
  }
  return print(headingOf(data, setting) + table.text(), session);
}

Result<std::vector<DataSet>> readAll(const std::vector<std::string>& paths,
                                     const Session& session) {
  std::vector<DataSet> all;
  for (const std::string& path : paths) {
    CUTIS_TRY(data, readData(path, {session.context.stop, {}, session.context.notice}));
    all.push_back(std::move(data));
  }
  return all;
}

Status runValidateCommand(const ValidateCommand& command, Session& session) {
  CUTIS_CHECK(requireCapture(command.capture));
  CUTIS_TRY(setting, parseMeasurement(command.measurement));
  CUTIS_TRY(models, loadModels(command.profiles, session));
  if (!command.capture.rig.empty()) {
    CUTIS_TRY(files, readAll(command.spectra, session));
    return runCaptureCommand(command.capture,
                             {files, command.profiles, models, command.measurement, command.plot},
                             session);
  }
  CUTIS_CHECK(checkPlots(command, models));
  CUTIS_TRY(rig, loadRig(kRig, {}, "rig"));
  CUTIS_TRY(all, readAll(command.spectra, session));
  CUTIS_CHECK(print(legend(), session));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto total = static_cast<double>(all.size());
    CUTIS_CHECK(validateOn(
        all[i], command, models, setting, rig, session,
        session.context.child(static_cast<double>(i) / total, static_cast<double>(i + 1) / total)));
  }
  return {};
}

}  // namespace

void addValidateCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<ValidateCommand>();
  CLI::App& command =
      addCommand(app, invocation, "validate",
                 "How well profiles describe and predict measured reflectance spectra", options,
                 runValidateCommand);
  addOption(command, "SPECTRA", options->spectra, "",
            "Comma-separated values as for fit-spectra, one or several files that were "
            "measured alike")
      ->required();
  addOption(command, "--profile", options->profiles, "NAME|FILE",
            "Skin models, separated by commas: built-in names or JSON files (default: all "
            "that are built in)")
      ->delimiter(',')
      ->allow_extra_args(false);
  addMeasurementOptions(command, options->measurement);
  addOption(command, "--plot", options->plot, "FILE",
            "Residual spectra as SVG or PNG, one file for each file of spectra and profile: "
            "their names are added to this one; with --capture errors by wavelength in one file");
  addCaptureOptions(command, options->capture);
}

}  // namespace cutis
