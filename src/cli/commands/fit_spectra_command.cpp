// fit-spectra: measured reflectance spectra to parameters.

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "core/fit/spectra/free_spectra_fit.h"
#include "src/cli/command.h"
#include "src/cli/options/free_options.h"
#include "src/cli/options/measurement_options.h"
#include "src/cli/options/option_values.h"
#include "src/cli/output_check.h"
#include "src/files/io/atomic_write.h"
#include "src/files/io/csv.h"
#include "src/files/measured_spectra.h"
#include "src/files/profiles/profile_file.h"

namespace cutis {
namespace {

struct FitSpectraCommand {
  std::string measured;
  std::string output;
  std::string range = "400:700";
  std::string profile = kDefaultProfile;
  MeasurementArguments measurement;
  std::string free;
};

Result<WavelengthRange> rangeOf(const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos) {
    return usageError("--range",
                      "'" + text + "' is not a range; write FROM:TO in nm, such as 400:700");
  }
  constexpr double least = kFirstWavelengthNm, most = kLastWavelengthNm;
  CUTIS_TRY(from, realNumber("--range", text.substr(0, colon), least, most));
  CUTIS_TRY(to, realNumber("--range", text.substr(colon + 1), least, most));
  if (from < to) return WavelengthRange{from, to};
  return usageError("--range", "'" + text + "' is empty; write the smaller wavelength first");
}

// A name that would read as a comment, or that holds quotes, is quoted.
std::string quotedId(const std::string& id) {
  if (!id.starts_with('#') && id.find('"') == std::string::npos) return id;
  std::string text = "\"";
  for (const char c : id) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + '"';
}

std::string tableOf(const std::vector<std::string>& ids, const std::vector<FreeSpectrumFit>& fits,
                    const FreeConstants& free) {
  std::string text = "id";
  for (const Parameter parameter : kParameters) {
    text += ',';
    text += parameterName(parameter);
  }
  if (free.oxygenation) text += ",oxygenation";
  if (free.thickness) text += ",thickness_mm";
  text += ",rmse\n";
  for (std::size_t i = 0; i < fits.size(); ++i) {
    text += quotedId(ids[i]);
    for (const double value : fits[i].fit.parameters)
      text += ',' + formatNumber(value);
    if (free.oxygenation) text += ',' + formatNumber(fits[i].constants.oxygenation);
    if (free.thickness) text += ',' + formatNumber(fits[i].constants.thicknessMm);
    text += ',' + formatNumber(fits[i].fit.rmse) + '\n';
  }
  return text;
}

// fits: at least one.
std::string summaryOf(const std::vector<FreeSpectrumFit>& fits, double seconds) {
  std::vector<double> errors;
  double sum = 0.0;
  for (const FreeSpectrumFit& found : fits) {
    errors.push_back(found.fit.rmse);
    sum += found.fit.rmse;
  }
  std::sort(errors.begin(), errors.end());
  const std::size_t of95 = (errors.size() * 95 + 99) / 100 - 1;
  const double mean = sum / static_cast<double>(errors.size());
  return std::to_string(errors.size()) + (errors.size() == 1 ? " spectrum" : " spectra") +
         ", RMSE mean " + formatNumber(mean, 4) + ", 95 % within " + formatNumber(errors[of95], 4) +
         ", max " + formatNumber(errors.back(), 4) + ", " + formatNumber(seconds, 3) + " s\n";
}

Status printSummary(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return {};
  return resourceError("standard output", "it cannot be written to; use --quiet");
}

Status runFitSpectraCommand(const FitSpectraCommand& command, Session& session) {
  const auto start = std::chrono::steady_clock::now();
  CUTIS_TRY(range, rangeOf(command.range));
  CUTIS_TRY(setting, parseMeasurement(command.measurement));
  CUTIS_TRY(free, freeConstants("--free", command.free));
  CUTIS_CHECK(checkTextOutput(command.output, {command.measured, command.profile}));
  CUTIS_TRY(model, session.engine.model(command.profile, "--profile"));
  CUTIS_TRY(spectra,
            readMeasuredSpectra(command.measured, range, fewestWavelengths(free), session.context));
  CUTIS_TRY(fits, fitSpectraFreely(*model, spectra.wavelengthsNm, spectra.reflectances, free,
                                   session.context.child(0.0, 1.0, "fitting spectra"),
                                   geometryOf(setting, model->profile())));
  CUTIS_CHECK(writeTextAtomically(command.output, tableOf(spectra.ids, fits, free)));
  if (session.quiet) return {};
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return printSummary(summaryOf(fits, taken.count()));
}

}  // namespace

void addFitSpectraCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<FitSpectraCommand>();
  CLI::App& command =
      addCommand(app, invocation, "fit-spectra",
                 "Parameters of the skin that comes closest to measured reflectance spectra",
                 options, runFitSpectraCommand);
  command
      .add_option("MEASURED", options->measured,
                  "Comma-separated values: reflectance from 0 to 1, wavelengths in nm in the first "
                  "row (one spectrum a row) or in the first column (one spectrum a column)")
      ->required()
      ->type_name("");
  command
      .add_option("-o,--output", options->output,
                  "File to write: id, the five parameters, what --free names and the RMSE of each "
                  "spectrum")
      ->required()
      ->type_name("FILE");
  command
      .add_option("--range", options->range,
                  "Wavelengths that count, in nm; between the model's, 2 nm apart, it is "
                  "interpolated linearly (default: 400:700)")
      ->type_name("FROM:TO");
  command
      .add_option("--profile", options->profile,
                  "Skin model: a built-in name or a JSON file (default: skin2026)")
      ->type_name("NAME|FILE");
  command
      .add_option("--free", options->free,
                  "Constants of the profile to find for each spectrum, too: oxygenation (of the "
                  "dermis's blood, 0 to 1; that of the epidermis moves along), thickness (of the "
                  "epidermis, 0.02 to 0.5 mm; with diffusion not below what it can describe), or "
                  "both with a comma; columns oxygenation and thickness_mm before rmse (default: "
                  "none)")
      ->type_name("NAMES");
  addMeasurementOptions(command, options->measurement);
}

}  // namespace cutis
