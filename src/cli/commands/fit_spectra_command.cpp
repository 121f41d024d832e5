// fit-spectra: measured reflectance spectra to parameters.

#include <chrono>

#include "core/base/echoed_text.h"
#include "core/base/number_text.h"
#include "core/evaluate/validation.h"
#include "core/fit/spectra/free_spectra_fit.h"
#include "src/cli/command.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/free_options.h"
#include "src/cli/options/measurement_options.h"
#include "src/cli/options/option_values.h"
#include "src/cli/output_check.h"
#include "src/cli/standard_output.h"
#include "src/files/io/atomic_write.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/spectra/measured_spectra_file.h"

namespace cutis {
namespace {

struct FitSpectraCommand {
  std::string measured;
  std::string output;
  std::string range = "400:700";
  std::string profile = kDefaultProfile;
  MeasurementOptions measurement;
  std::string free;
};

Result<WavelengthRange> wavelengthRangeOf(const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos) {
    return usageError("--range",
                      inQuotes(text) + " is not a range; write FROM:TO in nm, such as 400:700");
  }
  constexpr double least = kFirstWavelengthNm, most = kLastWavelengthNm;
  CUTIS_TRY(from, realNumber("--range", text.substr(0, colon), least, most));
  CUTIS_TRY(to, realNumber("--range", text.substr(colon + 1), least, most));
  if (from < to) return WavelengthRange{from, to};
  return usageError("--range", inQuotes(text) + " is empty; write the smaller wavelength first");
}

// A name that would read as a comment or as several fields is quoted.
std::string quotedId(const std::string& id) {
  if (!id.starts_with('#') && id.find_first_of(",\"\n\r") == std::string::npos) return id;
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

std::string summaryOf(const std::vector<FreeSpectrumFit>& fits, double seconds) {
  std::vector<double> errors;
  for (const FreeSpectrumFit& found : fits)
    errors.push_back(found.fit.rmse);
  const ErrorDistribution rmse = distributionOf(errors);
  return std::to_string(errors.size()) + (errors.size() == 1 ? " spectrum" : " spectra") +
         ", RMSE mean " + formatNumber(rmse.mean, 4) + ", 95 % within " +
         formatNumber(rmse.within95, 4) + ", max " + formatNumber(rmse.most, 4) + ", " +
         formatNumber(seconds, 3) + " s\n";
}

Status runFitSpectraCommand(const FitSpectraCommand& command, Session& session) {
  const auto start = std::chrono::steady_clock::now();
  CUTIS_TRY(range, wavelengthRangeOf(command.range));
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
  return printText(summaryOf(fits, taken.count()), "it cannot be written to; use --quiet");
}

}  // namespace

void addFitSpectraCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<FitSpectraCommand>();
  CLI::App& command =
      addCommand(app, invocation, "fit-spectra",
                 "Parameters of the skin that comes closest to measured reflectance spectra",
                 options, runFitSpectraCommand);
  addOption(command, "MEASURED", options->measured, "",
            "A table of reflectance spectra, with the wavelengths in its first row (one spectrum "
            "a row) or its first column (one spectrum a column), or a spectrometer's own export")
      ->required();
  addOption(command, "-o,--output", options->output, "FILE",
            "File to write: id, the five parameters, what --free names and the RMSE of each "
            "spectrum")
      ->required();
  addOption(command, "--range", options->range, "FROM:TO",
            "Wavelengths that count, in nm; between the model's, 2 nm apart, it is "
            "interpolated linearly (default: 400:700)");
  addProfileOption(command, options->profile, kDefaultProfile);
  addOption(command, "--free", options->free, "NAMES",
            "Constants of the profile to find for each spectrum, too: oxygenation (of the "
            "dermis's blood, 0 to 1; that of the epidermis moves along), thickness (of the "
            "epidermis, 0.02 to 0.5 mm; with diffusion not below what it can describe), or "
            "both with a comma; columns oxygenation and thickness_mm before rmse (default: "
            "none)");
  addMeasurementOptions(command, options->measurement);
}

}  // namespace cutis
