// spectrum: parameters to reflectance spectra.

#include <fstream>
#include <functional>
#include <limits>

#include "core/base/echoed_text.h"
#include "src/app/fit_method.h"
#include "src/app/spectrum_rows.h"
#include "src/cli/command.h"
#include "src/cli/commands/maps_input.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/measurement_options.h"
#include "src/cli/options/option_values.h"
#include "src/cli/output_check.h"
#include "src/cli/standard_output.h"
#include "src/files/io/atomic_write.h"
#include "src/files/io/csv.h"
#include "src/files/parameter_sets.h"
#include "src/files/profiles/fit_record_file.h"
#include "src/files/profiles/profile_file.h"

namespace cutis {
namespace {

struct SpectrumCommand {
  std::string parameters;
  std::string csv;
  std::string maps;
  std::vector<std::string> places;
  bool deviations = false;
  std::string output;
  std::string profile;
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

// Text to where the command writes.
Status writeOutput(const std::string& output, const std::function<Status(const TextSink&)>& make) {
  if (output.empty()) return make(writeToStandardOutput);
  return writeAtomically(output, [&](const std::filesystem::path& temporary) -> Status {
    std::ofstream stream(temporary, std::ios::binary);
    const auto write = [&](std::string_view text) -> Status {
      stream.write(text.data(), static_cast<std::streamsize>(text.size()));
      if (stream) return {};
      return resourceError(output, "the file cannot be written; free some disk space");
    };
    CUTIS_CHECK(make(write));
    stream.close();
    return write({});
  });
}

Result<std::vector<PixelPlace>> placesOf(const SpectrumCommand& command) {
  std::vector<PixelPlace> places;
  for (const std::string& text : command.places) {
    const std::vector<std::string> parts = commaSeparated(text);
    if (parts.size() != 2) {
      return usageError("--at", "must be two numbers such as 812,440, not " + inQuotes(text));
    }
    CUTIS_TRY(x, wholeNumber("--at", parts[0], 0, std::numeric_limits<int>::max() - 1));
    CUTIS_TRY(y, wholeNumber("--at", parts[1], 0, std::numeric_limits<int>::max() - 1));
    places.push_back({x, y});
  }
  return places;
}

// What the maps say of the fit that made them.
Result<FitRecord> recordOf(const OpenedMaps& opened, const std::string& path) {
  const MapsAttributes& attributes = opened.file.attributes;
  if (!attributes.fit.empty())
    return parseFitRecord(attributes.fit, opened.model->profile(), path + ": attribute cutis:fit");
  if (!attributes.method.empty() && attributes.method != fitMethodName(FitMethod::refined)) {
    return usageError("--deviation", "the maps were made by the method " + attributes.method +
                                         ", which knows no deviations; leave this out");
  }
  return inputError(
      path,
      "the maps do not say how they were fitted, because they were edited or an older "
      "version wrote them; leave out --deviation, or fit the image again");
}

Status writeSpectraOfMaps(const SpectrumCommand& command, Session& session) {
  if (!command.measurement.specular.empty() || !command.measurement.share.empty()) {
    return usageError("--specular", "this does not go with --maps; leave it out");
  }
  CUTIS_TRY(places, placesOf(command));
  CUTIS_TRY(opened,
            openMaps(command.maps, command.profile, session, session.context.child(0.0, 0.1)));
  MapSpectraOptions options = {places, {}};
  if (command.deviations) {
    CUTIS_TRY(record, recordOf(opened, command.maps));
    options.deviationsOf = record;
  }
  return writeOutput(command.output, [&](const TextSink& write) {
    return writeMapSpectra(opened.model, opened.file.maps, options, command.maps, write,
                           session.context.child(0.1, 1.0));
  });
}

Status runSpectrumCommand(const SpectrumCommand& command, Session& session) {
  const int given =
      int{!command.parameters.empty()} + int{!command.csv.empty()} + int{!command.maps.empty()};
  if (given != 1) return usageError("spectrum", "give one of --params, --csv and --maps");
  if (command.maps.empty() && !command.places.empty()) {
    return usageError("--at", "this goes with --maps; leave it out");
  }
  if (command.maps.empty() && command.deviations) {
    return usageError("--deviation", "this goes with --maps; leave it out");
  }
  CUTIS_TRY(setting, parseMeasurement(command.measurement));
  if (!command.output.empty()) {
    CUTIS_CHECK(checkTextOutput(command.output, {command.csv, command.maps, command.profile}));
  }
  if (!command.maps.empty()) return writeSpectraOfMaps(command, session);
  const std::string profile = command.profile.empty() ? kDefaultProfile : command.profile;
  CUTIS_TRY(model, session.engine.model(profile, "--profile"));
  CUTIS_TRY(sets, setsOf(command, model->profile().axes));
  const InstrumentModel measured(*model, geometryOf(setting, model->profile()));
  return writeOutput(command.output, [&](const TextSink& write) {
    return writeSpectra(measured, sets, write, session.context);
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
  addOption(command, "--maps", options->maps, "MAPS",
            "Maps that fit has written: a row for each pixel with an estimate, with x and y in "
            "front, and with everything that the maps hold");
  addOption(command, "--at", options->places, "X,Y",
            "Of these pixels of the maps alone, counted from 0,0; may be repeated")
      ->allow_extra_args(false);
  command.add_flag("--deviation", options->deviations,
                   "With --maps: behind the spectra their posterior standard deviations, columns "
                   "sd300 to sd1000");
  addOption(command, "-o,--output", options->output, "FILE",
            "File to write (default: standard output)");
  addProfileOption(command, options->profile, kDefaultProfile);
  addMeasurementOptions(command, options->measurement);
}

}  // namespace cutis
