#include "src/cli/commands/validate/capture_command.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "core/base/echoed_text.h"
#include "core/base/number_text.h"
#include "core/calibrate/capture_study.h"
#include "core/calibrate/discrepancy_learning.h"
#include "src/cli/commands/validate/capture_plot.h"
#include "src/cli/commands/validate/capture_table.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/option_values.h"
#include "src/cli/output_check.h"
#include "src/cli/standard_output.h"
#include "src/files/io/atomic_write.h"
#include "src/files/rig_file.h"
#include "src/report/picture_file.h"

namespace cutis {
namespace {

constexpr double kMostCaptureNoise = 0.2;
constexpr int kMostHalvings = 1000;
constexpr int kFewestFolds = 2, kMostFolds = 1000;

// A file's name without folder and extension, as one word of a table.
std::string captureWord(const std::string& path) {
  std::string word = std::filesystem::path(path).stem().string();
  std::replace_if(
      word.begin(), word.end(),
      [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0 || c == ','; }, '_');
  return word;
}

Status checkDifferent(const std::vector<std::string>& words, const std::string& place,
                      const std::string& what) {
  const std::set<std::string> different(words.begin(), words.end());
  if (different.size() == words.size()) return {};
  return usageError(place, "two " + what + " are called the same; rename one of them, or give " +
                               "one at a time");
}

std::string countedPeople(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " person" : " people");
}

// Whether there are people enough for halves, parts, and another file to learn from.
Status checkPeople(const CapturedFile& file, const CaptureStudy& study) {
  const std::size_t people = peopleOf(file.spectra).size();
  if (study.halvings > 0 && people < 2 * kFewestPeople) {
    return inputError(file.path, "too few people for halves: " + std::to_string(people) +
                                     " where at least " + std::to_string(2 * kFewestPeople) +
                                     " are needed; give more, or --halvings 0");
  }
  const auto folds = static_cast<std::size_t>(study.folds);
  if (folds > 0 && (people < folds || people - (people + folds - 1) / folds < kFewestPeople)) {
    return inputError(file.path, "too few people for " + std::to_string(folds) + " parts: of " +
                                     std::to_string(people) +
                                     " every part needs one, and what is "
                                     "left " +
                                     std::to_string(kFewestPeople) +
                                     "; give more, or another number with --folds");
  }
  if (study.sets.size() > 1 && people < kFewestPeople) {
    return inputError(file.path, "too few people to learn from: " + std::to_string(people) +
                                     " where at least " + std::to_string(kFewestPeople) +
                                     " are needed; give this file alone");
  }
  return {};
}

// Whether the spectra can be photographed and, as far as asked for, learned from.
Status checkFile(const CapturedFile& file, const CaptureStudy& study) {
  const MeasuredSpectra& spectra = file.spectra;
  const double from = spectra.wavelengthsNm.front(), to = spectra.wavelengthsNm.back();
  if (from > kFittedRange.fromNm || to < kFittedRange.toNm) {
    return inputError(file.path, "a photograph takes spectra from 400 to 700 nm, measured are " +
                                     formatNumber(from) + " to " + formatNumber(to) + " nm");
  }
  const double surface = study.models.front().geometry.specularShare;
  for (std::size_t i = 0; i < spectra.ids.size(); ++i) {
    const auto values = spectrumAt(spectra, i);
    for (std::size_t w = 0; w < values.size(); ++w) {
      const double nm = spectra.wavelengthsNm[w];
      if (!kFittedRange.contains(nm) || values[w] > surface) continue;
      const std::string where =
          "the spectrum " + inQuotes(spectra.ids[i]) + " at " + formatNumber(nm) + " nm is ";
      if (surface == 0.0) return inputError(file.path, where + "0, which skin never is");
      return inputError(file.path, where + formatNumber(values[w], 4) +
                                       ", no more than the surface reflection; give a smaller "
                                       "--specular-share");
    }
  }
  return checkPeople(file, study);
}

Result<CaptureStudy> captureStudyOf(const CaptureOptions& options, const CaptureRequest& request) {
  CaptureStudy study;
  CUTIS_TRY(rig, loadRig(options.rig, {}, "--capture"));
  study.rig = rig;
  if (!options.noise.empty()) {
    CUTIS_TRY(noise, realNumber("--noise", options.noise, 0.0, kMostCaptureNoise));
    study.noise = noise;
  }
  if (!options.halvings.empty()) {
    CUTIS_TRY(halvings, wholeNumber("--halvings", options.halvings, 0, kMostHalvings));
    study.halvings = halvings;
  }
  if (!options.folds.empty()) {
    CUTIS_TRY(folds, wholeNumber("--folds", options.folds, kFewestFolds, kMostFolds));
    study.folds = folds;
  }
  if (!options.seed.empty()) {
    CUTIS_TRY(seed, seedNumber("--seed", options.seed));
    study.seed = seed;
  }
  if (!request.measurement.apertureRadius.empty()) {
    return usageError("--aperture-radius", "photographs know no aperture; leave this out");
  }
  CUTIS_TRY(setting, parseMeasurement(request.measurement));
  if (!request.measurement.specular.empty()) study.surface = SurfaceLight::removed;
  for (const auto& model : request.models) {
    CUTIS_CHECK(requireFive(model->profile(), "a fit of photographs"));
    study.models.push_back({model, geometryOf(setting, model->profile())});
  }
  for (const CapturedFile& file : request.files)
    study.sets.push_back(file.spectra);
  for (const CapturedFile& file : request.files)
    CUTIS_CHECK(checkFile(file, study));
  return study;
}

Status checkCaptureOutputs(const CaptureOptions& options, const CaptureRequest& request) {
  std::vector<std::string> inputs = request.profileFiles;
  for (const CapturedFile& file : request.files)
    inputs.push_back(file.path);
  inputs.push_back(options.rig);
  if (!options.table.empty()) CUTIS_CHECK(checkTextOutput(options.table, inputs));
  if (request.plot.empty()) return {};
  CUTIS_CHECK(checkDistinct(request.plot, options.table));
  CUTIS_CHECK(checkNotInput(request.plot, inputs));
  return checkDrawingOutput(request.plot);
}

// "Photographs under the rig monitor, 0.5 % of noise, with the reflection of the surface"
std::string photographsInWords(const CaptureStudy& study) {
  std::string words = "Photographs under the rig " + study.rig.name + ", ";
  words += study.noise > 0.0 ? percentText(study.noise, 3) + " of noise" : "no noise";
  words += study.surface == SurfaceLight::removed ? ", without the reflection of the surface"
                                                  : ", spectra as they are";
  const double share = study.models.front().geometry.specularShare;
  if (share > 0.0) words += " (" + formatNumber(share, 4) + " taken off)";
  return words;
}

std::string captureLegend(const CaptureStudy& study) {
  std::string text = photographsInWords(study) +
                     ".\nRMSE of reflectance over people; then the share of wavelengths at which "
                     "two deviations hold what was\nmeasured, and medians of the dark, middle and "
                     "light third.\n";
  if (study.halvings > 0) {
    text +=
        "people-left-out: learned from half of a file's people, judged on the other half; "
        "means over " +
        std::to_string(2 * study.halvings) +
        " random halves.\nSpectra of one name are one person's.\n";
  }
  if (study.folds > 0) {
    text += "fold-left-out: the people in " + std::to_string(study.folds) +
            " random parts, each judged by what all others taught; figures of all people.\n";
  }
  if (study.sets.size() > 1) {
    text += "set-left-out: learned from one file, judged on the other.\n";
  }
  if (study.halvings > 0 || study.folds > 0 || study.sets.size() > 1) {
    text +=
        "Profiles keep their constants and learn what they leave over; wiener and wiener2 are "
        "the linear and the\nquadratic Wiener estimate, trained on the same spectra, of at "
        "most " +
        std::to_string(kMostLearned) + " people.\n";
  }
  return text;
}

std::string captureHeading(const CapturedFile& file) {
  const MeasuredSpectra& spectra = file.spectra;
  const std::size_t people = peopleOf(spectra).size();
  std::string text = "\n" + std::filesystem::path(file.path).filename().string() + ": ";
  if (people != spectra.ids.size()) text += std::to_string(spectra.ids.size()) + " spectra of ";
  return text + countedPeople(people) + ", " + formatNumber(spectra.wavelengthsNm.front()) + "-" +
         formatNumber(spectra.wavelengthsNm.back()) + " nm\n";
}

}  // namespace

void addCaptureOptions(CLI::App& command, CaptureOptions& options) {
  addOption(
      command, "--capture", options.rig, "RIG",
      "Photograph the spectra by arithmetic under this rig, a built-in name or a rig.json, fit "
      "the photographs, and compare, beside Wiener estimates, on people and files left out. "
      "Spectra are photographed as they are; with --specular, light without the surface "
      "reflection is");
  addOption(command, "--noise", options.noise, "P",
            "With --capture: standard deviation of the photographs' channels over themselves "
            "(default: 0, fitted in the exact setting)");
  addOption(command, "-o", options.table, "TABLE.csv", "With --capture: the figures as a table");
  addOption(
      command, "--halvings", options.halvings, "N",
      "With --capture: times to halve the people at random, learn from each half and judge on "
      "the other (default: 10)");
  addOption(command, "--folds", options.folds, "K",
            "With --capture: also divide the people at random into K parts, learn from all but one "
            "and judge on that, part after part (default: not done)");
  addOption(command, "--seed", options.seed, "N",
            "With --capture: seed of noise, halves and parts (default: 1)");
}

Status requireCapture(const CaptureOptions& options) {
  if (!options.rig.empty()) return {};
  using Given = std::pair<const char*, const std::string&>;
  for (const auto& [name, text] :
       {Given("--noise", options.noise), Given("-o", options.table),
        Given("--halvings", options.halvings), Given("--folds", options.folds),
        Given("--seed", options.seed)}) {
    if (!text.empty()) return usageError(name, "this goes with --capture");
  }
  return {};
}

Status runCaptureCommand(const CaptureOptions& options, const CaptureRequest& request,
                         Session& session) {
  CaptureNames names;
  for (const CapturedFile& file : request.files)
    names.sets.push_back(captureWord(file.path));
  for (const auto& model : request.models)
    names.models.push_back(captureWord(model->profile().name));
  CUTIS_CHECK(checkDifferent(names.sets, "SPECTRA", "files"));
  CUTIS_CHECK(checkDifferent(names.models, "--profile", "profiles"));
  CUTIS_CHECK(checkCaptureOutputs(options, request));
  CUTIS_TRY(study, captureStudyOf(options, request));
  CUTIS_TRY(results, runCaptureStudy(study, session.context));
  if (!options.table.empty()) {
    CUTIS_CHECK(writeTextAtomically(options.table, captureCsv(results, names)));
  }
  if (!request.plot.empty()) {
    CUTIS_CHECK(writeDrawing(request.plot,
                             capturePlot(results, study.sets, names, photographsInWords(study))));
  }
  std::string text = captureLegend(study);
  for (std::size_t i = 0; i < request.files.size(); ++i)
    text += captureHeading(request.files[i]) + captureTables(results, i, study.sets[i], names);
  session.clearProgress();
  return printText(text, kTablesLost);
}

}  // namespace cutis
