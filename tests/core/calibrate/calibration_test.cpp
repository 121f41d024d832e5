// Constants that made spectra are found from the spectra again, bounds and pull hold, and the prior
// of a population is that of its people.

#include "core/calibrate/calibration.h"

#include <cmath>

#include <QtTest>

#include "core/base/random.h"
#include "core/calibrate/population_prior.h"
#include "core/fit/population.h"
#include "core/skin/model/instrument_model.h"
#include "src/files/profiles/profile_file.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr double kTrueThickness = 0.21;
constexpr double kTrueOxygenation = 0.55;
constexpr double kTrueShare = 0.03;

// Thickness, oxygenation and specular share of a profile.
CalibrationPoint pointOf(Profile profile, std::span<const double> constants) {
  profile.epidermalThicknessMm = constants[0];
  profile.dermalBlood.oxygenation = constants[1];
  profile.epidermalBlood.oxygenation = constants[1];
  const double index = profile.refractiveIndex;
  return {profile, {measurementGeometry(SpecularPart::included, index, constants[2])}};
}

std::vector<int> everyTenNm(int fromNm, int toNm) {
  std::vector<int> samples;
  for (int wavelength = fromNm; wavelength <= toNm; wavelength += 10) {
    samples.push_back((wavelength - kFirstWavelengthNm) / kWavelengthStepNm);
  }
  return samples;
}

SpectraSet spectraOf(const CalibrationPoint& point, const std::vector<ParameterVector>& people) {
  const SkinModel skin(point.profile);
  const InstrumentModel model(skin, point.geometries[0]);
  SpectraSet set;
  set.samples = everyTenNm(340, 960);
  set.measured.resize(static_cast<Eigen::Index>(set.samples.size()),
                      static_cast<Eigen::Index>(people.size()));
  for (std::size_t i = 0; i < people.size(); ++i) {
    for (std::size_t s = 0; s < set.samples.size(); ++s) {
      set.measured(static_cast<Eigen::Index>(s), static_cast<Eigen::Index>(i)) =
          model.reflectanceAt(set.samples[s], people[i]);
    }
  }
  set.aims = {{400.0, 700.0, 0.005}, {340.0, 400.0, 0.012}, {700.0, 960.0, 0.012}};
  return set;
}

CalibrationProblem problemOf(const Profile& profile, const SpectraSet& set) {
  CalibrationProblem problem;
  problem.sets = {set};
  problem.constants = {{"thickness", 0.1, 0.4, 0.25, 0.3, true},
                       {"oxygenation", 0.3, 1.0, 0.7, 0.2, false},
                       {"share", 0.0, 0.08, 0.04, 0.02, false}};
  problem.pointAt = [profile](std::span<const double> constants) {
    return pointOf(profile, constants);
  };
  return problem;
}

const std::vector<double> kTruth = {kTrueThickness, kTrueOxygenation, kTrueShare};
const std::vector<double> kStart = {0.3, 0.8, 0.05};

class CalibrationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    people_ = drawPopulation(protocolPopulation(), 24, 5);
    set_ = spectraOf(pointOf(profile_, kTruth), people_);
  }

  void theConstantsThatMadeTheSpectraAreFound() {
    const auto found = calibrate(problemOf(profile_, set_), kStart, {});
    QVERIFY(bool(found));
    QVERIFY(found.value().converged);
    for (std::size_t k = 0; k < kTruth.size(); ++k) {
      EXPECT_NEAR(found.value().constants[k], kTruth[k], 0.02 * kTruth[k]);
    }
    // The cost is a mean of squared errors over squared aims.
    EXPECT_AT_MOST(found.value().cost, 1e-3);
  }

  void thePullLeadsToWhatIsExpected() {
    CalibrationProblem problem = problemOf(profile_, set_);
    problem.pull = 1e6;
    const auto found = calibrate(problem, kStart, {});
    QVERIFY(bool(found));
    for (std::size_t k = 0; k < kTruth.size(); ++k) {
      const double expected = problem.constants[k].expected;
      EXPECT_NEAR(found.value().constants[k], expected, 0.01 * expected);
    }
  }

  void boundsHold() {
    CalibrationProblem problem = problemOf(profile_, set_);
    problem.constants[0].high = 0.15;
    const auto found = calibrate(problem, {0.12, 0.8, 0.05}, {});
    QVERIFY(bool(found));
    EXPECT_NEAR(found.value().constants[0], 0.15, 1e-9);
    // The others do what they can.
    const auto free = calibrate(problem, {0.14, 0.6, 0.03}, {});
    QVERIFY(bool(free));
    EXPECT_NEAR(free.value().cost, found.value().cost, 0.02 * found.value().cost);
  }

  void noiseDoesNotLeadAstray() {
    SpectraSet noisy = set_;
    Random random(3);
    for (double& value : noisy.measured.reshaped())
      value += 0.002 * random.normal();
    const auto found = calibrate(problemOf(profile_, noisy), kStart, {});
    QVERIFY(bool(found));
    for (std::size_t k = 0; k < kTruth.size(); ++k) {
      EXPECT_NEAR(found.value().constants[k], kTruth[k], 0.1 * kTruth[k]);
    }
  }

  void stops() {
    std::stop_source source;
    source.request_stop();
    const auto found = calibrate(problemOf(profile_, set_), kStart, {source.get_token(), {}, {}});
    QVERIFY(found.cancelled());
  }

  void someSpectraAreChosen() {
    const std::vector<std::size_t> choice = {3, 3, 0};
    const SpectraSet some = selected(set_, choice);
    QCOMPARE(some.count(), Eigen::Index{3});
    QVERIFY((some.measured.col(0) == set_.measured.col(3)).all());
    QVERIFY((some.measured.col(1) == set_.measured.col(3)).all());
    QVERIFY((some.measured.col(2) == set_.measured.col(0)).all());
  }

  // The prior moves from the wide one towards that of the people.
  void thePriorIsThatOfThePeople() {
    Prior truth = profile_.prior;
    truth.mean = {0.05, 0.6, 0.03, 0.02, 0.001};
    truth.deviation = {0.4, 0.1, 0.3, 0.3, 0.3};
    truth.correlation(0, 2) = truth.correlation(2, 0) = -0.5;
    constexpr int kPeople = 300;
    const auto people = drawFromPrior(truth, profile_.axes, kPeople, 8);
    const CalibrationPoint point = pointOf(profile_, std::vector<double>{0.25, 0.75, 0.04});
    const SkinModel skin(point.profile);
    const auto found = populationPrior(skin, point.geometries[0], spectraOf(point, people), 2e-4,
                                       profile_.prior, {});
    QVERIFY(bool(found));
    for (const int k : {0, 2, 3}) {
      EXPECT_NEAR(std::log(found.value().mean[k] / truth.mean[k]), 0.0, 0.1);
      EXPECT_NEAR(found.value().deviation[k], truth.deviation[k], 0.15 * truth.deviation[k]);
    }
    EXPECT_NEAR(found.value().mean[kMelaninBlend], 0.6, 0.03);
    EXPECT_NEAR(found.value().correlation(0, 2), -0.5, 0.12);
  }

 private:
  const Profile profile_ = test::li2024().profile();
  std::vector<ParameterVector> people_;
  SpectraSet set_;
};

CUTIS_TEST(CalibrationTest)

}  // namespace
}  // namespace cutis

#include "calibration_test.moc"
