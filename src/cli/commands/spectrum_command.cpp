// spectrum: parameters to reflectance spectra.

#include <fstream>

#include "src/app/spectrum_rows.h"
#include "src/cli/command.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/measurement_options.h"
#include "src/cli/output_check.h"
#include "src/cli/standard_output.h"
#include "src/files/io/atomic_write.h"
#include "src/files/io/csv.h"
#include "src/files/parameter_sets.h"
#include "src/files/profiles/profile_file.h"

namespace cutis {
namespace {

struct SpectrumCommand {
  std::string parameters;
  std::string csv;
  std::string output;
  std::string profile = kDefaultProfile;
  MeasurementOptions measurement;
};

Result<std::vector<ParameterVector>> setsOf(const SpectrumCommand& command,
                                            const ParameterAxes& axes) {
  if (!command.csv.empty()) return readParameterSets(command.csv, axes);
  const CsvTable rows = splitCsv(command.parameters);
  CUTIS_TRY(set,
            parseParameters(rows.empty() ? std::span<const std::string_view>() : rows[0].fields,
                            axes, "--params", ErrorKind::input));
  return std::vector<ParameterVector>{set};
}

Status writeToStandardOutput(std::string_view text) {
  return printText(text, "it cannot be written to; use -o");
}

Status runSpectrumCommand(const SpectrumCommand& command, Session& session) {
  if (command.parameters.empty() == command.csv.empty()) {
    return usageError("spectrum", "give either --params or --csv");
  }
  CUTIS_TRY(setting, parseMeasurement(command.measurement));
  if (!command.output.empty()) {
    CUTIS_CHECK(checkTextOutput(command.output, {command.csv, command.profile}));
  }
  CUTIS_TRY(model, session.engine.model(command.profile, "--profile"));
  CUTIS_TRY(sets, setsOf(command, model->profile().axes));
  const InstrumentModel measured(*model, geometryOf(setting, model->profile()));
  if (command.output.empty()) {
    return writeSpectra(measured, sets, writeToStandardOutput, session.context);
  }
  return writeAtomically(command.output, [&](const std::filesystem::path& temporary) -> Status {
    std::ofstream stream(temporary, std::ios::binary);
    const auto write = [&](std::string_view text) -> Status {
      stream.write(text.data(), static_cast<std::streamsize>(text.size()));
      if (stream) return {};
      return resourceError(command.output, "the file cannot be written; free some disk space");
    };
    CUTIS_CHECK(writeSpectra(measured, sets, write, session.context));
    stream.close();
    return write({});
  });
}

}  // namespace

void addSpectrumCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<SpectrumCommand>();
  CLI::App& command = addCommand(
      app, invocation, "spectrum",
      "Reflectance spectra of skin, 300 to 1000 nm in steps of 2 nm, as comma-separated values",
      options, runSpectrumCommand);
  addOption(command, "--params", options->parameters, "M,B,HD,HE,C",
            "One set: melanin, melanin blend, dermal and epidermal haemoglobin (volume "
            "fractions), carotene (g/L)");
  addOption(command, "--csv", options->csv, "FILE",
            "File with the header " + parameterNames(",") + " and one set per row");
  addOption(command, "-o,--output", options->output, "FILE",
            "File to write (default: standard output)");
  addProfileOption(command, options->profile, kDefaultProfile);
  addMeasurementOptions(command, options->measurement);
}

}  // namespace cutis
