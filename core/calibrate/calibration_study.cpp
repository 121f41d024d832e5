#include "core/calibrate/calibration_study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/random.h"
#include "core/calibrate/population_prior.h"
#include "core/evaluate/validation.h"
#include "core/skin/model/skin_model.h"

namespace cutis {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
// The narrowest interval that a constant usually has.
constexpr int kDigits = 3;
constexpr int kPriorDigits = 4;
// Which of the random sequences.
constexpr std::uint64_t kHalvingStream = 1;
constexpr std::uint64_t kBootstrapStream = 2;

// The wavelengths compared, of those that were measured.
SpectraSet setOf(const StudiedSpectra& studied, int stepNm) {
  const MeasuredSpectra& spectra = studied.spectra;
  SpectraSet set;
  for (int sample = 0; sample < kSampleCount; ++sample) {
    const int wavelength = kFirstWavelengthNm + kWavelengthStepNm * sample;
    const bool measured =
        wavelength >= spectra.wavelengthsNm.front() && wavelength <= spectra.wavelengthsNm.back();
    if (measured && wavelength % stepNm == 0) set.samples.push_back(sample);
  }
  set.measured.resize(static_cast<Eigen::Index>(set.samples.size()),
                      static_cast<Eigen::Index>(spectra.ids.size()));
  for (std::size_t i = 0; i < spectra.ids.size(); ++i) {
    const Spectrum spectrum = onGrid(spectra, i);
    set.measured.col(static_cast<Eigen::Index>(i)) = spectrum(set.samples);
  }
  set.aims = studied.aims;
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

class StudyRun {
 public:
  StudyRun(const CalibrationStudy& study, const JobContext& context)
      : study_(study), context_(context) {
    for (const StudiedSpectra& spectra : study.spectra) {
      sets_.push_back(setOf(spectra, study.stepNm));
      measured_.push_back(spectra.spectra);
    }
  }

  Result<CalibrationFigures> run() {
    const double parts = 1.0 + 2.0 * study_.halvings + study_.bootstraps;
    double done = 0.0;
    const auto next = [&](const std::string& stage) {
      const double from = done / parts;
      done += 1.0;
      return context_.child(from, done / parts, stage);
    };
    CUTIS_TRY(best, calibrated(sets_, startConstants(), next("calibrating")));
    for (double& constant : best) {
      constant = roundedTo(constant, kDigits);
      figures_.constants.push_back({constant, kNone, kNone});
    }
    CUTIS_CHECK(judgeAll(best));
    for (int halving = 0; halving < study_.halvings; ++halving) {
      const auto [one, other] = halves(halving);
      CUTIS_CHECK(judgeHalf(one, other, best, next("calibrating on half of the spectra")));
      CUTIS_CHECK(judgeHalf(other, one, best, next("calibrating on half of the spectra")));
    }
    for (int bootstrap = 0; bootstrap < study_.bootstraps; ++bootstrap) {
      CUTIS_TRY(drawn, calibrated(chosen(redrawn(bootstrap)), best, next("drawing spectra again")));
      bootstraps_.push_back(std::move(drawn));
    }
    summariseHalves();
    summariseBootstraps();
    return std::move(figures_);
  }

 private:
  // One judgement of all sets, as in CalibrationFigures.
  using Judgement = std::vector<std::array<double, kJudgedRangeCount>>;

  std::vector<double> startConstants() const {
    std::vector<double> start;
    for (const StudiedConstant& constant : study_.constants)
      start.push_back(constant.start);
    return start;
  }

  std::vector<MeasurementGeometry> geometriesFor(std::span<const double> constants,
                                                 const Profile& profile) const {
    std::vector<MeasurementGeometry> geometries;
    for (std::size_t i = 0; i < study_.spectra.size(); ++i) {
      const StudiedSpectra& spectra = study_.spectra[i];
      double share = spectra.specularShare;
      for (std::size_t k = 0; k < constants.size(); ++k) {
        if (study_.constants[k].spectra == i) share = constants[k];
      }
      geometries.push_back(measurementGeometry(spectra.specular, profile.refractiveIndex, share));
      geometries.back().edgeLossPerMm = spectra.edgeLossPerMm;
    }
    return geometries;
  }

  Result<CalibrationPoint> pointAt(std::span<const double> constants) const {
    CUTIS_TRY(profile, study_.profileAt(constants));
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
    for (const StudiedConstant& constant : study_.constants)
      problem.constants.push_back(constant.constant);
    problem.pull = study_.pull;
    problem.pointAt = [this](std::span<const double> constants) { return pointAt(constants); };
    CUTIS_TRY(calibration, calibrate(problem, start, context));
    return calibration.constants;
  }

  std::pair<Choice, Choice> halves(int halving) const {
    Random random(study_.seed + static_cast<std::uint64_t>(halving), kHalvingStream);
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
    Random random(study_.seed + static_cast<std::uint64_t>(bootstrap), kBootstrapStream);
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
    CUTIS_TRY(found, populationPrior(*plain, point.geometries[study_.priorSpectra], priorSpectra,
                                     study_.priorNoise, point.profile.prior, silent));
    for (int k = 0; k < kParameterCount; ++k) {
      found.mean[k] = roundedTo(found.mean[k], kPriorDigits);
      found.deviation[k] = roundedTo(found.deviation[k], kPriorDigits);
    }
    prior = found;
    point.profile.prior = found;
    return SkinModel::create(point.profile, silent);
  }

  Result<Judgement> judged(const std::vector<double>& constants, const SkinModel& model,
                           const std::vector<MeasuredSpectra>& spectra) const {
    Judgement judgement;
    const auto geometries = geometriesFor(constants, model.profile());
    for (std::size_t i = 0; i < spectra.size(); ++i) {
      CUTIS_TRY(figures, validateModel(model, spectra[i], geometries[i], study_.colorRig,
                                       {context_.stop, {}, {}}));
      judgement.push_back({figures.fitted.mean, figures.ultraviolet.mean, figures.nearInfrared.mean,
                           figures.fromColor.median});
    }
    return judgement;
  }

  Status judgeAll(const std::vector<double>& constants) {
    CUTIS_TRY(model, modelOf(constants, sets_[study_.priorSpectra], figures_.prior));
    CUTIS_TRY(judgement, judged(constants, *model, measured_));
    for (const auto& errors : judgement) {
      figures_.errors.emplace_back();
      for (std::size_t range = 0; range < errors.size(); ++range)
        figures_.errors.back()[range].all = errors[range];
    }
    return {};
  }

  // Calibrates on one half and adds how the other fares.
  Status judgeHalf(const Choice& half, const Choice& other, const std::vector<double>& start,
                   const JobContext& context) {
    const std::vector<SpectraSet> sets = chosen(half);
    CUTIS_TRY(constants, calibrated(sets, start, context));
    Prior prior;
    CUTIS_TRY(model, modelOf(constants, sets[study_.priorSpectra], prior));
    std::vector<MeasuredSpectra> leftOut;
    for (std::size_t i = 0; i < measured_.size(); ++i)
      leftOut.push_back(selected(measured_[i], other[i]));
    CUTIS_TRY(judgement, judged(constants, *model, leftOut));
    leftOut_.push_back(std::move(judgement));
    return {};
  }

  void summariseHalves() {
    for (std::size_t i = 0; i < figures_.errors.size(); ++i) {
      for (std::size_t range = 0; range < kJudgedRangeCount; ++range) {
        CalibrationError& error = figures_.errors[i][range];
        error.leftOut = error.worst = leftOut_.empty() ? kNone : 0.0;
        for (const Judgement& half : leftOut_) {
          error.leftOut += half[i][range] / static_cast<double>(leftOut_.size());
          error.worst = std::max(error.worst, half[i][range]);
        }
      }
    }
  }

  void summariseBootstraps() {
    if (bootstraps_.empty()) return;
    for (std::size_t k = 0; k < figures_.constants.size(); ++k) {
      std::vector<double> drawn;
      for (const auto& bootstrap : bootstraps_)
        drawn.push_back(bootstrap[k]);
      std::sort(drawn.begin(), drawn.end());
      const auto at = [&](double share) {
        return drawn[static_cast<std::size_t>(
            std::lround(share * static_cast<double>(drawn.size() - 1)))];
      };
      figures_.constants[k].low = roundedTo(at(0.05), kDigits);
      figures_.constants[k].high = roundedTo(at(0.95), kDigits);
    }
  }

  const CalibrationStudy& study_;
  const JobContext& context_;
  std::vector<SpectraSet> sets_;
  std::vector<MeasuredSpectra> measured_;
  std::vector<Judgement> leftOut_;               // [half]
  std::vector<std::vector<double>> bootstraps_;  // [bootstrap][constant]
  CalibrationFigures figures_;
};

}  // namespace

Result<CalibrationFigures> runStudy(const CalibrationStudy& study, const JobContext& context) {
  return StudyRun(study, context).run();
}

}  // namespace cutis
