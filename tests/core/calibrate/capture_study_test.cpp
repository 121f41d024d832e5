// A study of photographs: what is judged by whom, that halves and noise follow the seed alone, and
// that what was learned from skin unlike the model's is nearer to it than the model.

#include "core/calibrate/capture_study.h"

#include <algorithm>
#include <cmath>

#include <QtTest>
#include <tbb/global_control.h>

#include "core/fit/population.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// Skin that differs from the model's by a wave, every 10 nm.
MeasuredSpectra wavySkin(int people, std::uint64_t seed, double toNm) {
  MeasuredSpectra spectra;
  for (double nm = 400.0; nm <= toNm; nm += 10.0)
    spectra.wavelengthsNm.push_back(nm);
  for (const ParameterVector& person : drawPopulation(protocolPopulation(), people, seed)) {
    spectra.ids.push_back(std::to_string(spectra.ids.size()));
    const Spectrum spectrum = test::li2024().reflectance(person);
    for (const double nm : spectra.wavelengthsNm) {
      const auto sample = std::lround((nm - kFirstWavelengthNm) / kWavelengthStepNm);
      spectra.reflectances.push_back(spectrum[static_cast<Eigen::Index>(sample)] *
                                     (1.0 + 0.05 * std::sin(nm / 15.0)));
    }
  }
  return spectra;
}

CaptureStudy wavyStudy() {
  CaptureStudy study;
  study.sets = {wavySkin(20, 1, 740.0)};
  study.models = {{std::make_shared<const SkinModel>(test::li2024().profile()), {}}};
  study.rig = test::monitorRig();
  study.noise = 0.005;
  study.halvings = 1;
  return study;
}

double medianOf(const std::vector<CaptureResult>& results, CaptureEstimator estimator,
                CaptureScheme scheme, std::size_t range = 0) {
  for (const CaptureResult& result : results) {
    if (result.estimator == estimator && result.scheme == scheme) {
      return result.figures[0][range].median;
    }
  }
  return std::nan("");
}

// Estimates without deviations have no coverage.
bool areSame(double one, double other) {
  return one == other || (std::isnan(one) && std::isnan(other));
}

bool areSame(const std::vector<CaptureResult>& one, const std::vector<CaptureResult>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const CaptureResult& a, const CaptureResult& b) {
                      return areSame(a.figures[0][0].median, b.figures[0][0].median) &&
                             areSame(a.figures[0][0].coverage, b.figures[0][0].coverage) &&
                             a.medianErrors == b.medianErrors;
                    });
}

class CaptureStudyTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsLearnedHelps() {
    const auto results = runCaptureStudy(wavyStudy(), {});
    EXPECT_OK(results);
    // As shipped, the model learned from halves, and two Wiener estimates.
    QCOMPARE(results.value().size(), std::size_t{4});
    const double shipped =
        medianOf(results.value(), CaptureEstimator::refined, CaptureScheme::asShipped);
    const double learned =
        medianOf(results.value(), CaptureEstimator::refined, CaptureScheme::peopleLeftOut);
    EXPECT_AT_MOST(learned, 0.5 * shipped);
    for (const auto estimator : {CaptureEstimator::wiener, CaptureEstimator::quadraticWiener}) {
      const double wiener = medianOf(results.value(), estimator, CaptureScheme::peopleLeftOut);
      QVERIFY(wiener > 0.0 && wiener < 0.05);
      // Nothing was measured below 400 nm.
      QVERIFY(std::isnan(medianOf(results.value(), estimator, CaptureScheme::peopleLeftOut, 1)));
      QVERIFY(medianOf(results.value(), estimator, CaptureScheme::peopleLeftOut, 2) > 0.0);
    }
    for (const CaptureResult& result : results.value()) {
      QCOMPARE(result.medianErrors.size(), std::size_t{35});
      QCOMPARE(std::isnan(result.figures[0][0].coverage),
               result.estimator != CaptureEstimator::refined);
      for (std::size_t group = 1; group < kCaptureGroups; ++group)
        QVERIFY(result.figures[group][0].worst <= result.figures[0][0].worst + 1e-12);
    }
  }

  void theSeedDecidesAndThreadsDoNot() {
    CaptureStudy study = wavyStudy();
    const auto all = runCaptureStudy(study, {});
    EXPECT_OK(all);
    {
      const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
      const auto alone = runCaptureStudy(study, {});
      EXPECT_OK(alone);
      QVERIFY(areSame(all.value(), alone.value()));
    }
    study.seed = 2;
    const auto others = runCaptureStudy(study, {});
    EXPECT_OK(others);
    QVERIFY(!areSame(all.value(), others.value()));
  }

  void setsAreJudgedByEachOther() {
    CaptureStudy study = wavyStudy();
    study.halvings = 0;
    study.sets = {wavySkin(8, 1, 740.0), wavySkin(8, 2, 700.0)};
    const auto results = runCaptureStudy(study, {});
    EXPECT_OK(results);
    QCOMPARE(results.value().size(), std::size_t{8});
    for (std::size_t set = 0; set < 2; ++set) {
      for (std::size_t i = 4 * set; i < 4 * set + 4; ++i) {
        const CaptureResult& result = results.value()[i];
        QCOMPARE(result.set, set);
        const bool isShipped = result.scheme == CaptureScheme::asShipped;
        QCOMPARE(isShipped, i == 4 * set);
        if (!isShipped) QCOMPARE(result.learnedFrom, 1 - set);
      }
    }
    // Beyond 700 nm the second set taught nothing to those who know no physics.
    QVERIFY(results.value()[1].figures[0][2].median > 0.0);
    QVERIFY(std::isnan(results.value()[2].figures[0][2].median));
  }

  void partsJudgeEverybodyOnce() {
    CaptureStudy study = wavyStudy();
    study.halvings = 0;
    study.folds = 20;
    const auto alone = runCaptureStudy(study, {});
    EXPECT_OK(alone);
    QCOMPARE(alone.value().size(), std::size_t{4});
    const double shipped =
        medianOf(alone.value(), CaptureEstimator::refined, CaptureScheme::asShipped);
    const double learned =
        medianOf(alone.value(), CaptureEstimator::refined, CaptureScheme::foldLeftOut);
    EXPECT_AT_MOST(learned, 0.5 * shipped);
    QVERIFY(medianOf(alone.value(), CaptureEstimator::wiener, CaptureScheme::foldLeftOut) > 0.0);
    // All people are counted at once: nobody is worse than the worst, and coverage is a share of
    // them all.
    for (const CaptureResult& result : alone.value()) {
      double worst = 0.0;
      for (std::size_t group = 1; group < kCaptureGroups; ++group)
        worst = std::max(worst, result.figures[group][0].worst);
      QCOMPARE(worst, result.figures[0][0].worst);
    }
    // With one person a part chance decides nothing but the noise.
    study.noise = 0.0;
    const auto one = runCaptureStudy(study, {});
    study.seed = 2;
    const auto other = runCaptureStudy(study, {});
    EXPECT_OK(one);
    EXPECT_OK(other);
    QVERIFY(areSame(one.value(), other.value()));
    study.folds = 2;
    const auto halves = runCaptureStudy(study, {});
    EXPECT_OK(halves);
    QVERIFY(!areSame(one.value(), halves.value()));
  }

  void aDiscrepancyCanBeLeftOut() {
    CaptureStudy study = wavyStudy();
    study.halvings = 0;
    Profile profile = test::li2024().profile();
    Discrepancy known;
    known.components = Eigen::MatrixXd::Constant(kSampleCount, 1, 0.02);
    known.slope = Eigen::MatrixXd::Zero(1, kParameterCount);
    known.covariance = Eigen::MatrixXd::Identity(1, 1);
    known.rest = Eigen::MatrixXd::Zero(kSampleCount, 0);
    known.prior = profile.prior;
    profile.discrepancies.surfaceIncluded = known;
    study.models = {{std::make_shared<const SkinModel>(profile), {}}};
    const auto results = runCaptureStudy(study, {});
    EXPECT_OK(results);
    QCOMPARE(results.value().size(), std::size_t{2});
    QVERIFY(results.value()[1].scheme == CaptureScheme::withoutDiscrepancy);
    // Learned for photographs with the reflection, it says nothing of those without.
    study.surface = SurfaceLight::removed;
    const auto removed = runCaptureStudy(study, {});
    EXPECT_OK(removed);
    QCOMPARE(removed.value().size(), std::size_t{1});
  }

  void stopsIfAsked() {
    std::stop_source source;
    source.request_stop();
    QVERIFY(runCaptureStudy(wavyStudy(), {source.get_token(), {}, {}}).cancelled());
  }
};

CUTIS_TEST(CaptureStudyTest)

}  // namespace
}  // namespace cutis

#include "capture_study_test.moc"
