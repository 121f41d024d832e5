#include "src/cli/commands/calibrate_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "core/base/random.h"
#include "core/calibrate/calibration.h"
#include "core/calibrate/population_prior.h"
#include "core/skin/model/skin_model.h"
#include "src/cli/text_table.h"
#include "src/files/io/csv.h"
#include "src/files/profiles/profile_edit.h"
#include "src/files/profiles/profile_file.h"

namespace cutis {
namespace {

constexpr double kNotAvailable = std::numeric_limits<double>::quiet_NaN();
constexpr char kMadePlace[] = "the calibrated profile";
// Of a constant in the profile: its interval is rarely narrower.
constexpr int kConstantDigits = 3;
constexpr int kPriorDigits = 4;
constexpr int kErrorDecimals = 4;
// Which of the random sequences.
constexpr std::uint64_t kHalvingStream = 1;
constexpr std::uint64_t kBootstrapStream = 2;

double rounded(double value, int digits) {
  return parseNumber(formatNumber(value, digits)).value_or(value);
}

std::string displayName(const CalibrationRecipe& recipe, const CalibrationConstant& constant) {
  const std::string& field = constant.constant.name;
  return constant.spectra ? recipe.spectra[*constant.spectra].name + " " + field : field;
}

// The wavelengths compared, of those that were measured.
SpectraSet setOf(const MeasuredSpectra& spectra, const CalibrationRecipe& recipe,
                 const CalibrationSpectra& described) {
  SpectraSet set;
  for (int sample = 0; sample < kSampleCount; ++sample) {
    const int wavelength = kFirstWavelengthNm + kWavelengthStepNm * sample;
    const bool measured =
        wavelength >= spectra.wavelengthsNm.front() && wavelength <= spectra.wavelengthsNm.back();
    if (measured && wavelength % recipe.stepNm == 0) set.samples.push_back(sample);
  }
  set.measured.resize(static_cast<Eigen::Index>(set.samples.size()),
                      static_cast<Eigen::Index>(spectra.ids.size()));
  for (std::size_t i = 0; i < spectra.ids.size(); ++i) {
    const Spectrum spectrum = onGrid(spectra, i);
    set.measured.col(static_cast<Eigen::Index>(i)) = spectrum(set.samples);
  }
  set.aims = described.aims;
  return set;
}

// Which spectra of each set.
using Choice = std::vector<std::vector<std::size_t>>;

std::vector<std::size_t> shuffled(std::size_t count, Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) {
    std::swap(order[i - 1], order[random.bits() % i]);
  }
  return order;
}

class ProfileCalibrator {
 public:
  ProfileCalibrator(const CalibrationInput& input, const JobContext& context)
      : input_(input), recipe_(input.recipe), context_(context) {
    for (std::size_t i = 0; i < input.spectra.size(); ++i) {
      sets_.push_back(setOf(input.spectra[i], recipe_, recipe_.spectra[i]));
    }
  }

  Result<CalibratedProfile> run() {
    CUTIS_TRY(start, startConstants());
    const double parts = 1.0 + 2.0 * input_.halvings + input_.bootstraps;
    double done = 0.0;
    const auto next = [&](const std::string& stage) {
      const double from = done / parts;
      done += 1.0;
      return context_.child(from, done / parts, stage);
    };
    CUTIS_TRY(best, calibrated(sets_, start, next("calibrating")));
    for (double& constant : best)
      constant = rounded(constant, kConstantDigits);
    describeConstants(start, best);
    CUTIS_CHECK(judgeAll(best));
    for (int halving = 0; halving < input_.halvings; ++halving) {
      const auto [one, other] = halves(halving);
      CUTIS_CHECK(judgeHalf(one, other, best, next("calibrating on half of the spectra")));
      CUTIS_CHECK(judgeHalf(other, one, best, next("calibrating on half of the spectra")));
    }
    for (int bootstrap = 0; bootstrap < input_.bootstraps; ++bootstrap) {
      CUTIS_TRY(drawn, calibrated(chosen(redrawn(bootstrap)), best, next("drawing spectra again")));
      bootstraps_.push_back(std::move(drawn));
    }
    summarise();
    result_.text = editedProfile(recipe_.startText, finalEdits(best));
    CUTIS_CHECK(parseProfile(result_.text, kMadePlace));
    return std::move(result_);
  }

 private:
  Result<std::vector<double>> startConstants() const {
    std::vector<double> start;
    for (const CalibrationConstant& constant : recipe_.constants) {
      if (constant.spectra) {
        start.push_back(recipe_.spectra[*constant.spectra].specularShare);
        continue;
      }
      CUTIS_TRY(value, profileNumber(recipe_.startText, constant.constant.name, recipe_.start));
      start.push_back(value);
    }
    return start;
  }

  // Everything constants change in the profile.
  ProfileEdits editsFor(std::span<const double> constants) const {
    ProfileEdits edits;
    for (std::size_t k = 0; k < constants.size(); ++k) {
      if (recipe_.constants[k].spectra) continue;
      edits.numbers.emplace_back(recipe_.constants[k].constant.name, constants[k]);
    }
    return edits;
  }

  std::vector<MeasurementGeometry> geometriesFor(std::span<const double> constants,
                                                 const Profile& profile) const {
    std::vector<MeasurementGeometry> geometries;
    for (std::size_t i = 0; i < recipe_.spectra.size(); ++i) {
      const CalibrationSpectra& spectra = recipe_.spectra[i];
      double share = spectra.specularShare;
      for (std::size_t k = 0; k < constants.size(); ++k) {
        if (recipe_.constants[k].spectra == i) share = constants[k];
      }
      geometries.push_back(measurementGeometry(spectra.specular, profile.refractiveIndex, share));
      geometries.back().edgeLossPerMm = spectra.edgeLossPerMm;
    }
    return geometries;
  }

  Result<CalibrationPoint> pointAt(std::span<const double> constants) const {
    CUTIS_TRY(profile,
              parseProfile(editedProfile(recipe_.startText, editsFor(constants)), kMadePlace));
    const std::vector<MeasurementGeometry> geometries = geometriesFor(constants, profile);
    return CalibrationPoint{profile, geometries};
  }

  std::vector<SpectraSet> chosen(const Choice& choice) const {
    std::vector<SpectraSet> some;
    for (std::size_t i = 0; i < sets_.size(); ++i)
      some.push_back(selected(sets_[i], choice[i]));
    return some;
  }

  Result<std::vector<double>> calibrated(const std::vector<SpectraSet>& sets,
                                         const std::vector<double>& start,
                                         const JobContext& context) const {
    CalibrationProblem problem;
    problem.sets = sets;
    for (const CalibrationConstant& constant : recipe_.constants) {
      problem.constants.push_back(constant.constant);
    }
    problem.pull = recipe_.pull;
    problem.pointAt = [this](std::span<const double> constants) { return pointAt(constants); };
    CUTIS_TRY(calibration, calibrate(problem, start, context));
    return calibration.constants;
  }

  std::pair<Choice, Choice> halves(int halving) const {
    Random random(input_.seed + static_cast<std::uint64_t>(halving), kHalvingStream);
    std::pair<Choice, Choice> result;
    for (const SpectraSet& set : sets_) {
      const auto order = shuffled(static_cast<std::size_t>(set.count()), random);
      const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
      result.first.emplace_back(order.begin(), middle);
      result.second.emplace_back(middle, order.end());
    }
    return result;
  }

  Choice redrawn(int bootstrap) const {
    Random random(input_.seed + static_cast<std::uint64_t>(bootstrap), kBootstrapStream);
    Choice choice;
    for (const SpectraSet& set : sets_) {
      const auto count = static_cast<std::size_t>(set.count());
      std::vector<std::size_t> drawn(count);
      for (std::size_t& spectrum : drawn)
        spectrum = random.bits() % count;
      choice.push_back(std::move(drawn));
    }
    return choice;
  }

  // The model of some constants with the prior of those spectra.
  Result<std::shared_ptr<const SkinModel>> modelOf(std::span<const double> constants,
                                                   const SpectraSet& priorSpectra,
                                                   Prior& prior) const {
    CUTIS_TRY(point, pointAt(constants));
    const JobContext silent = {context_.stop, {}, {}};
    CUTIS_TRY(plain, SkinModel::create(point.profile, silent));
    CUTIS_TRY(found, populationPrior(*plain, point.geometries[recipe_.priorSpectra], priorSpectra,
                                     recipe_.priorNoise, point.profile.prior, silent));
    for (int k = 0; k < kParameterCount; ++k) {
      found.mean[k] = rounded(found.mean[k], kPriorDigits);
      found.deviation[k] = rounded(found.deviation[k], kPriorDigits);
    }
    prior = found;
    point.profile.prior = found;
    return SkinModel::create(point.profile, silent);
  }

  // Errors in the order of result_.errors.
  Result<std::vector<double>> judged(const std::vector<double>& constants, const SkinModel& model,
                                     const std::vector<MeasuredSpectra>& spectra) const {
    std::vector<double> errors;
    const auto geometries = geometriesFor(constants, model.profile());
    for (std::size_t i = 0; i < spectra.size(); ++i) {
      CUTIS_TRY(figures, validateModel(model, spectra[i], geometries[i], input_.colorRig,
                                       {context_.stop, {}, {}}));
      for (const double error : {figures.fitted.mean, figures.ultraviolet.mean,
                                 figures.nearInfrared.mean, figures.fromColor.median}) {
        errors.push_back(error);
      }
    }
    return errors;
  }

  Status judgeAll(const std::vector<double>& constants) {
    CUTIS_TRY(model, modelOf(constants, sets_[recipe_.priorSpectra], prior_));
    CUTIS_TRY(errors, judged(constants, *model, input_.spectra));
    for (std::size_t i = 0; i < errors.size(); ++i) {
      static constexpr std::array<const char*, 4> kRanges = {"400-700 nm", "320-400 nm, predicted",
                                                             "700-1000 nm, predicted",
                                                             "400-700 nm from colour, median"};
      result_.errors.push_back(
          {recipe_.spectra[i / kRanges.size()].name, kRanges[i % kRanges.size()], errors[i], 0, 0});
    }
    return {};
  }

  // Calibrates on one half and adds how the other fares.
  Status judgeHalf(const Choice& half, const Choice& other, const std::vector<double>& start,
                   const JobContext& context) {
    const std::vector<SpectraSet> sets = chosen(half);
    CUTIS_TRY(constants, calibrated(sets, start, context));
    Prior prior;
    CUTIS_TRY(model, modelOf(constants, sets[recipe_.priorSpectra], prior));
    std::vector<MeasuredSpectra> leftOut;
    for (std::size_t i = 0; i < input_.spectra.size(); ++i) {
      leftOut.push_back(selected(input_.spectra[i], other[i]));
    }
    CUTIS_TRY(errors, judged(constants, *model, leftOut));
    leftOut_.push_back(std::move(errors));
    return {};
  }

  void describeConstants(const std::vector<double>& start, const std::vector<double>& best) {
    for (std::size_t k = 0; k < best.size(); ++k) {
      result_.constants.push_back({displayName(recipe_, recipe_.constants[k]), start[k], best[k],
                                   kNotAvailable, kNotAvailable});
    }
  }

  void summarise() {
    for (std::size_t i = 0; i < result_.errors.size(); ++i) {
      CalibrationError& error = result_.errors[i];
      error.leftOut = error.worst = leftOut_.empty() ? kNotAvailable : 0.0;
      for (const std::vector<double>& half : leftOut_) {
        error.leftOut += half[i] / static_cast<double>(leftOut_.size());
        error.worst = std::max(error.worst, half[i]);
      }
    }
    if (bootstraps_.empty()) return;
    for (std::size_t k = 0; k < result_.constants.size(); ++k) {
      std::vector<double> drawn;
      for (const auto& bootstrap : bootstraps_)
        drawn.push_back(bootstrap[k]);
      std::sort(drawn.begin(), drawn.end());
      const auto at = [&](double share) {
        return drawn[static_cast<std::size_t>(
            std::lround(share * static_cast<double>(drawn.size() - 1)))];
      };
      result_.constants[k].low = rounded(at(0.05), kConstantDigits);
      result_.constants[k].high = rounded(at(0.95), kConstantDigits);
    }
  }

  std::string sourceOf(std::size_t k) const {
    const ConstantFigures& figures = result_.constants[k];
    std::string text = "Calibrated";
    if (!bootstraps_.empty()) {
      text += ": " + formatNumber(figures.low) + " to " + formatNumber(figures.high);
    }
    const std::string& note = recipe_.constants[k].note;
    return text + "." + (note.empty() ? "" : " " + note);
  }

  std::string description() const {
    std::string text = recipe_.description;
    if (leftOut_.empty()) return text;
    text += " Mean RMSE on halves left out:";
    for (const CalibrationError& error : result_.errors) {
      if (std::isnan(error.leftOut)) continue;
      text += " " + error.spectra + " " + error.range + " " +
              fixedNumber(error.leftOut, kErrorDecimals) + ";";
    }
    text.back() = '.';
    return text;
  }

  ProfileEdits finalEdits(const std::vector<double>& constants) const {
    ProfileEdits edits = editsFor(constants);
    edits.name = recipe_.name;
    edits.description = description();
    edits.prior = prior_;
    for (std::size_t k = 0; k < constants.size(); ++k) {
      if (recipe_.constants[k].spectra) continue;
      edits.sources.emplace_back(recipe_.constants[k].constant.name, sourceOf(k));
    }
    return edits;
  }

  const CalibrationInput& input_;
  const CalibrationRecipe& recipe_;
  const JobContext& context_;
  std::vector<SpectraSet> sets_;
  Prior prior_;
  std::vector<std::vector<double>> leftOut_;     // [half][error]
  std::vector<std::vector<double>> bootstraps_;  // [bootstrap][constant]
  CalibratedProfile result_;
};

}  // namespace

Status checkSpectra(const CalibrationInput& input, const std::vector<std::string>& places) {
  const CalibrationRecipe& recipe = input.recipe;
  if (input.spectra.size() != recipe.spectra.size()) {
    const std::size_t files = recipe.spectra.size();
    return usageError("SPECTRA", "the calibration " + recipe.name + " takes " +
                                     std::to_string(files) + (files == 1 ? " file" : " files") +
                                     ", given were " + std::to_string(input.spectra.size()));
  }
  const std::size_t fewest = input.halvings > 0 ? 4 : 2;
  for (std::size_t i = 0; i < input.spectra.size(); ++i) {
    const MeasuredSpectra& spectra = input.spectra[i];
    if (spectra.ids.size() < fewest) {
      return inputError(places[i], "too few spectra: " + std::to_string(spectra.ids.size()) +
                                       " where at least " + std::to_string(fewest) + " are needed");
    }
    for (const SpectralAim& aim : recipe.spectra[i].aims) {
      const double from = std::min(aim.fromNm, kFittedFromNm);
      const double to = std::max(aim.toNm, kFittedToNm);
      if (spectra.wavelengthsNm.front() <= from && spectra.wavelengthsNm.back() >= to) continue;
      return inputError(places[i], "the calibration compares " + formatNumber(from) + " to " +
                                       formatNumber(to) + " nm, measured are " +
                                       formatNumber(spectra.wavelengthsNm.front()) + " to " +
                                       formatNumber(spectra.wavelengthsNm.back()) + " nm");
    }
  }
  return {};
}

Result<CalibratedProfile> calibrateProfile(const CalibrationInput& input,
                                           const JobContext& context) {
  return ProfileCalibrator(input, context).run();
}

}  // namespace cutis
