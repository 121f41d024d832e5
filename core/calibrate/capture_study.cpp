#include "core/calibrate/capture_study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/random.h"
#include "core/calibrate/calibration.h"
#include "core/calibrate/discrepancy_learning.h"
#include "core/evaluate/wiener_estimate.h"
#include "core/skin/layers/table.h"

namespace cutis {
namespace {

// Where a darker skin's ultraviolet is all but the surface's reflection, what is left after taking
// that off is error, and may be negative.
constexpr double kLeastBelowSurface = 0.003;
constexpr std::uint64_t kPeopleStream = 11, kLessonStream = 12, kCaptureNoiseStream = 13,
                        kFoldStream = 14;

// [person]
using PeopleChoice = std::vector<std::size_t>;
using People = std::vector<std::vector<std::size_t>>;

PeopleChoice inRandomOrder(std::size_t count, Random& random) {
  PeopleChoice order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[random.bits() % i]);
  return order;
}

std::vector<std::size_t> spectraOf(const People& people, const PeopleChoice& choice) {
  std::vector<std::size_t> spectra;
  for (const std::size_t person : choice)
    spectra.insert(spectra.end(), people[person].begin(), people[person].end());
  std::sort(spectra.begin(), spectra.end());
  return spectra;
}

// As many as may be learned from; every one of them where there are no more.
PeopleChoice learnable(const PeopleChoice& choice, std::uint64_t seed) {
  if (choice.size() <= kMostLearned) return choice;
  Random random(seed, kLessonStream);
  PeopleChoice some;
  for (const std::size_t place : inRandomOrder(choice.size(), random)) {
    if (some.size() < kMostLearned) some.push_back(choice[place]);
  }
  return some;
}

WavelengthRange reachOf(const MeasuredSpectra& spectra) {
  return {spectra.wavelengthsNm.front(), spectra.wavelengthsNm.back()};
}

// What is learned from, as asSeen() of discrepancy_study.cpp: all that was measured, without the
// surface's reflection.
SpectraSet learnedSet(const MeasuredSpectra& spectra, const MeasurementGeometry& geometry) {
  const WavelengthRange reach = reachOf(spectra);
  SpectraSet set;
  for (int sample = 0; sample < kSampleCount; ++sample) {
    if (reach.contains(wavelengthNm(sample))) set.samples.push_back(sample);
  }
  set.measured.resize(static_cast<Eigen::Index>(set.samples.size()),
                      static_cast<Eigen::Index>(spectra.ids.size()));
  for (std::size_t i = 0; i < spectra.ids.size(); ++i) {
    Spectrum skin = onGrid(spectra, i);
    if (geometry.specularShare > 0.0) {
      skin = ((skin - geometry.specularShare) / geometry.enteringShare).max(kLeastBelowSurface);
    }
    set.measured.col(static_cast<Eigen::Index>(i)) = skin(set.samples);
  }
  return set;
}

// The same skin with another discrepancy. Tables of radiative transfer do not depend on it.
std::shared_ptr<const SkinModel> withDiscrepancy(const SkinModel& model, SurfaceLight surface,
                                                 const Discrepancy& discrepancy) {
  Profile profile = model.profile();
  auto& place = surface == SurfaceLight::included ? profile.discrepancies.surfaceIncluded
                                                  : profile.discrepancies.surfaceRemoved;
  place = discrepancy;
  if (profile.layerOptics == LayerOpticsKind::diffusion) {
    return std::make_shared<const SkinModel>(profile);
  }
  std::vector<int> samples(kSampleCount);
  std::iota(samples.begin(), samples.end(), 0);
  std::vector<LayerPolynomial<double>> polynomials;
  for (const int sample : samples)
    polynomials.push_back(*model.optics().polynomialAt(sample));
  return std::make_shared<const SkinModel>(
      profile, std::make_shared<const LayerTable>(LayerTable::restore(samples, polynomials)));
}

// Means over judgements, each without those that have no figure.
class MeanFigure {
 public:
  void add(double value) {
    if (std::isnan(value)) return;
    sum_ += value;
    ++count_;
  }
  double mean() const {
    return count_ > 0 ? sum_ / count_ : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

class JudgementSum {
 public:
  // The people judged, and the third that each person of the set belongs to.
  void add(const MeasuredSpectra& spectra, const EstimatedSpectra& estimated, const People& people,
           const PeopleChoice& judged, const std::vector<std::size_t>& thirds) {
    std::array<People, kCaptureGroups> groups;
    for (const std::size_t person : judged) {
      groups[0].push_back(people[person]);
      groups[1 + thirds[person]].push_back(people[person]);
    }
    for (std::size_t group = 0; group < groups.size(); ++group) {
      for (std::size_t range = 0; range < kCaptureRanges.size(); ++range) {
        const CaptureFigures figures =
            captureFigures(kCaptureRanges[range], spectra, estimated, groups[group]);
        auto& sums = figures_[group][range];
        sums[0].add(figures.median);
        sums[1].add(figures.within95);
        sums[2].add(figures.worst);
        sums[3].add(figures.coverage);
      }
    }
    const std::vector<double> errors = cutis::medianErrors(spectra, estimated, groups[0]);
    medianErrors_.resize(errors.size());
    for (std::size_t w = 0; w < errors.size(); ++w)
      medianErrors_[w].add(errors[w]);
  }

  void writeTo(CaptureResult& result) const {
    for (std::size_t group = 0; group < kCaptureGroups; ++group) {
      for (std::size_t range = 0; range < kCaptureRanges.size(); ++range) {
        const auto& sums = figures_[group][range];
        CaptureFigures& figures = result.figures[group][range];
        figures.median = sums[0].mean();
        figures.within95 = sums[1].mean();
        figures.worst = sums[2].mean();
        figures.coverage = sums[3].mean();
      }
    }
    for (const MeanFigure& error : medianErrors_)
      result.medianErrors.push_back(error.mean());
  }

 private:
  std::array<std::array<std::array<MeanFigure, 4>, kCaptureRanges.size()>, kCaptureGroups> figures_;
  std::vector<MeanFigure> medianErrors_;
};

// One set that is judged on, prepared.
struct JudgedSet {
  std::size_t index = 0;
  const MeasuredSpectra* spectra = nullptr;
  People people;
  std::vector<std::size_t> thirds;  // [person]
};

// What was estimated of a set by one estimator, lesson after lesson: figures of each lesson by
// itself, or of all people at once when each was judged by one of them.
class Judgement {
 public:
  Judgement(const JudgedSet& set, CaptureScheme scheme)
      : set_(set), together_(scheme == CaptureScheme::foldLeftOut) {}

  void take(const EstimatedSpectra& estimated, const PeopleChoice& judged) {
    if (!together_) {
      sum_.add(*set_.spectra, estimated, set_.people, judged, set_.thirds);
      return;
    }
    if (all_.reflectance.size() == 0) all_ = estimated;
    for (const std::size_t spectrum : spectraOf(set_.people, judged)) {
      const auto column = static_cast<Eigen::Index>(spectrum);
      all_.reflectance.col(column) = estimated.reflectance.col(column);
      if (all_.deviation.size() > 0) {
        all_.deviation.col(column) = estimated.deviation.col(column);
      }
    }
    judged_.insert(judged_.end(), judged.begin(), judged.end());
  }

  void writeTo(CaptureResult& result) {
    if (together_) sum_.add(*set_.spectra, all_, set_.people, judged_, set_.thirds);
    sum_.writeTo(result);
  }

 private:
  const JudgedSet& set_;
  bool together_;
  JudgementSum sum_;
  EstimatedSpectra all_;
  PeopleChoice judged_;
};

// Photographs of the people of a set whom an estimator may learn from, and of those it is judged
// on.
struct Lesson {
  std::size_t learnedFrom = 0;  // set
  PeopleChoice learned;
  PeopleChoice judged;
  Rig rig;
  std::uint64_t noiseKey = 0;
};

class CaptureRun {
 public:
  CaptureRun(const CaptureStudy& study, const JobContext& context)
      : study_(study), context_(context) {
    for (std::size_t i = 0; i < study.sets.size(); ++i) {
      JudgedSet set = {i, &study.sets[i], peopleOf(study.sets[i]), {}};
      set.thirds = toneThirdsOf(*set.spectra, set.people);
      sets_.push_back(std::move(set));
    }
  }

  Result<std::vector<CaptureResult>> run() {
    for (const JudgedSet& set : sets_) {
      for (std::size_t model = 0; model < study_.models.size(); ++model)
        CUTIS_CHECK(judgeShipped(set, model));
      if (study_.halvings > 0) CUTIS_CHECK(judgeHalves(set));
      if (study_.folds > 0) CUTIS_CHECK(judgeFolds(set));
      for (const JudgedSet& other : sets_) {
        if (other.index != set.index) CUTIS_CHECK(judgeSetLeftOut(set, other));
      }
    }
    return std::move(results_);
  }

 private:
  // The next step of the whole: a lesson of a model or of both Wiener estimates, or a judgement as
  // shipped.
  JobContext next(const std::string& stage) {
    const auto sets = static_cast<double>(study_.sets.size());
    const auto models = static_cast<double>(study_.models.size());
    const double parts = sets * (models + 1.0) * (2.0 * study_.halvings + study_.folds + sets);
    const double from = done_ / parts;
    done_ += 1.0;
    return context_.child(std::min(from, 1.0), std::min(done_ / parts, 1.0), stage);
  }

  FitOptions optionsFor(bool discrepancy) const {
    FitOptions options;
    options.noise = study_.noise > 0.0 ? NoiseModel{study_.rig.noise.read, study_.noise, 0.0}
                                       : NoiseModel{0.0, 0.0, 0.0};
    options.discrepancy = discrepancy;
    options.surface = study_.surface;
    return options;
  }

  std::uint64_t noiseKey(const JudgedSet& set, std::size_t repetition) const {
    return mixBits(mixBits(mixBits(study_.seed) + kCaptureNoiseStream) + 1000 * set.index +
                   repetition);
  }

  PeopleChoice everyone(const JudgedSet& set) const {
    PeopleChoice all(set.people.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }

  Result<EstimatedSpectra> fitted(const std::shared_ptr<const SkinModel>& model,
                                  std::size_t modelIndex, const JudgedSet& set,
                                  const Lesson& lesson, bool discrepancy,
                                  const JobContext& context) const {
    const MeasurementGeometry& geometry = study_.models[modelIndex].geometry;
    const Eigen::MatrixXd channels =
        photographSpectra(lesson.rig, *set.spectra, geometry, study_.noise, lesson.noiseKey);
    return fitPhotographs(model, lesson.rig, optionsFor(discrepancy), channels,
                          spectraOf(set.people, lesson.judged), geometry,
                          set.spectra->wavelengthsNm, context);
  }

  Status judgeShipped(const JudgedSet& set, std::size_t model) {
    const JobContext context = next("fitting photographs");
    const auto& shipped = study_.models[model].model;
    Lesson lesson;
    lesson.judged = everyone(set);
    lesson.rig = rigWithin(study_.rig, reachOf(*set.spectra));
    lesson.noiseKey = noiseKey(set, 0);
    const bool hasOne = shipped->profile().discrepancies.of(study_.surface) != nullptr;
    for (const auto scheme : {CaptureScheme::asShipped, CaptureScheme::withoutDiscrepancy}) {
      const bool isShipped = scheme == CaptureScheme::asShipped;
      if (!isShipped && !hasOne) continue;
      Judgement judgement(set, scheme);
      CUTIS_TRY(estimated,
                fitted(shipped, model, set, lesson, isShipped,
                       context.child(isShipped ? 0.0 : 0.5, isShipped && hasOne ? 0.5 : 1.0)));
      judgement.take(estimated, lesson.judged);
      add(CaptureEstimator::refined, model, scheme, set, set.index, judgement);
    }
    return {};
  }

  Status judgeHalves(const JudgedSet& set) {
    std::vector<Lesson> lessons;
    for (int halving = 0; halving < study_.halvings; ++halving) {
      const auto repetition = static_cast<std::size_t>(halving);
      Random random(study_.seed + repetition, kPeopleStream);
      const PeopleChoice order = inRandomOrder(set.people.size(), random);
      const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
      const PeopleChoice one(order.begin(), middle), other(middle, order.end());
      for (const auto& [learned, judged] : {std::pair(one, other), std::pair(other, one)}) {
        lessons.push_back({set.index, learnable(learned, study_.seed), judged,
                           rigWithin(study_.rig, reachOf(*set.spectra)),
                           noiseKey(set, repetition)});
      }
    }
    return judgeLessons(set, CaptureScheme::peopleLeftOut, lessons);
  }

  Status judgeFolds(const JudgedSet& set) {
    Random random(study_.seed, kFoldStream);
    const PeopleChoice order = inRandomOrder(set.people.size(), random);
    const auto folds = static_cast<std::size_t>(study_.folds);
    std::vector<Lesson> lessons;
    for (std::size_t fold = 0; fold < folds; ++fold) {
      const std::size_t from = order.size() * fold / folds;
      const std::size_t to = order.size() * (fold + 1) / folds;
      PeopleChoice judged, others;
      for (std::size_t place = 0; place < order.size(); ++place)
        (place >= from && place < to ? judged : others).push_back(order[place]);
      lessons.push_back({set.index, learnable(others, study_.seed), judged,
                         rigWithin(study_.rig, reachOf(*set.spectra)), noiseKey(set, 0)});
    }
    return judgeLessons(set, CaptureScheme::foldLeftOut, lessons);
  }

  Status judgeSetLeftOut(const JudgedSet& set, const JudgedSet& other) {
    const Rig rig =
        rigWithin(rigWithin(study_.rig, reachOf(*set.spectra)), reachOf(*other.spectra));
    return judgeLessons(set, CaptureScheme::setLeftOut,
                        {{other.index, learnable(everyone(other), study_.seed), everyone(set), rig,
                          noiseKey(set, 0)}});
  }

  Status judgeLessons(const JudgedSet& set, CaptureScheme scheme,
                      const std::vector<Lesson>& lessons) {
    const std::size_t learnedFrom = lessons.front().learnedFrom;
    for (std::size_t model = 0; model < study_.models.size(); ++model) {
      Judgement judgement(set, scheme);
      for (const Lesson& lesson : lessons) {
        const JobContext context = next("learning from some, judging on others");
        CUTIS_TRY(learned, learnedModel(model, lesson, context.child(0.0, 0.9)));
        CUTIS_TRY(estimated, fitted(learned, model, set, lesson, true, context.child(0.9, 1.0)));
        judgement.take(estimated, lesson.judged);
      }
      add(CaptureEstimator::refined, model, scheme, set, learnedFrom, judgement);
    }
    Judgement linear(set, scheme), quadratic(set, scheme);
    for (const Lesson& lesson : lessons) {
      if (context_.stopRequested()) return Cancelled{};
      next("learning from some, judging on others");
      linear.take(wienerEstimated(set, lesson, WienerFeatures::channels), lesson.judged);
      quadratic.take(wienerEstimated(set, lesson, WienerFeatures::channelsAndSquares),
                     lesson.judged);
    }
    add(CaptureEstimator::wiener, 0, scheme, set, learnedFrom, linear);
    add(CaptureEstimator::quadraticWiener, 0, scheme, set, learnedFrom, quadratic);
    return {};
  }

  MeasuredSpectra learnedSpectra(const Lesson& lesson) const {
    const JudgedSet& from = sets_[lesson.learnedFrom];
    return selected(*from.spectra, spectraOf(from.people, lesson.learned));
  }

  Result<std::shared_ptr<const SkinModel>> learnedModel(std::size_t index, const Lesson& lesson,
                                                        const JobContext& context) const {
    const StudiedModel& studied = study_.models[index];
    DiscrepancyLearning options;
    options.prior = studied.model->profile().prior;
    CUTIS_TRY(learned,
              learnDiscrepancy(*studied.model, learnedSet(learnedSpectra(lesson), studied.geometry),
                               options, context));
    return withDiscrepancy(*studied.model, study_.surface, learned);
  }

  EstimatedSpectra wienerEstimated(const JudgedSet& set, const Lesson& lesson,
                                   WienerFeatures features) const {
    const MeasurementGeometry& geometry = study_.models.front().geometry;
    const MeasuredSpectra training = learnedSpectra(lesson);
    const WienerEstimate wiener(features, photographSpectra(lesson.rig, training, geometry, 0.0, 0),
                                resampled(training, set.spectra->wavelengthsNm),
                                {study_.rig.noise.read, study_.noise, 0.0});
    EstimatedSpectra estimated;
    estimated.reflectance = wiener.estimate(
        photographSpectra(lesson.rig, *set.spectra, geometry, study_.noise, lesson.noiseKey));
    return estimated;
  }

  void add(CaptureEstimator estimator, std::size_t model, CaptureScheme scheme,
           const JudgedSet& set, std::size_t learnedFrom, Judgement& judgement) {
    CaptureResult result;
    result.estimator = estimator;
    result.model = model;
    result.scheme = scheme;
    result.set = set.index;
    result.learnedFrom = learnedFrom;
    judgement.writeTo(result);
    results_.push_back(std::move(result));
  }

  const CaptureStudy& study_;
  const JobContext& context_;
  std::vector<JudgedSet> sets_;
  double done_ = 0.0;
  std::vector<CaptureResult> results_;
};

}  // namespace

Result<std::vector<CaptureResult>> runCaptureStudy(const CaptureStudy& study,
                                                   const JobContext& context) {
  return CaptureRun(study, context).run();
}

}  // namespace cutis
