// Deviations: the normal curve's where the posterior is one, and those of the posterior itself
// where it is not.

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <QtTest>

#include "core/base/random.h"
#include "core/evaluate/error_metrics.h"
#include "core/fit/population.h"
#include "core/fit/refined/refined_solver.h"
#include "core/skin/model/choose_nodes.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Covariance = Eigen::Matrix<double, 5, 5>;

Prior priorOfKind(bool log) {
  return log ? test::li2024().profile().prior : test::populationPrior();
}

// Solved pixels and their deviations.
struct Fitted {
  Fitted(const Prior& priorOfFit, const NoiseModel& noiseOfFit,
         const std::vector<ParameterVector>& people)
      : prior(priorOfFit),
        noise(noiseOfFit),
        pixels(test::simulate(test::monitorRig(), people, noiseOfFit.proportional)) {
    FitOptions options;
    options.prior = prior;
    options.noise = noise;
    const auto solver = makeRefinedSolver(test::sharedModel(), test::monitorRig(), options);
    solutions = test::solve(*solver, pixels);
    deviations.resize(solutions.parameters.size());
    solver->deviations(pixels.rows(), solutions.rows(),
                       packedRows(deviations.data(), kParameterCount, pixels.count));
  }

  test::Objective objective() const {
    return {test::li2024(), chooseNodes(test::li2024(), responseRows(test::monitorRig())), prior,
            noise};
  }
  // The deviation of the coordinate, which is the logarithm where the prior has it.
  double deviation(std::size_t pixel, int k) const {
    const double found = double{deviations[static_cast<std::size_t>(k) * pixels.count + pixel]};
    return prior.isLog(k) ? found / solutions.at(pixel)[k] : found;
  }

  Prior prior;
  NoiseModel noise;
  test::PixelSet pixels;
  test::Solutions solutions;
  std::vector<float> deviations;
};

// Whether the curve is cut off within five deviations.
bool meetsTheBox(const Fitted& fitted, const ParameterVector& at, double deviation, int k) {
  const double maximum = test::li2024().profile().axes[static_cast<std::size_t>(k)].maximum;
  if (fitted.prior.isLog(k)) return at[k] * std::exp(5.0 * deviation) > maximum;
  return at[k] - 5.0 * deviation < 0.0 || at[k] + 5.0 * deviation > maximum;
}

// Root mean square distances from the estimate of a Metropolis walk through the posterior.
ParameterVector walkedSpread(const test::Objective& objective, const Eigen::VectorXd& channels,
                             const ParameterVector& estimate, int steps, std::uint64_t seed) {
  const auto& axes = test::li2024().profile().axes;
  const ParameterVector start = objective.coordinates(estimate);
  const Covariance scale =
      objective.covariance(channels, estimate).llt().matrixL().toDenseMatrix() *
      (2.38 / std::sqrt(5.0));
  Random random(seed);
  ParameterVector at = start, sum = ParameterVector::Zero();
  double cost = objective.cost(channels, estimate);
  for (int step = 0; step < steps; ++step) {
    Eigen::Matrix<double, 5, 1> normal;
    for (double& value : normal)
      value = random.normal();
    const ParameterVector trial = at + (scale * normal).array();
    const ParameterVector parameters = objective.parameters(trial);
    bool inside = true;
    for (int k = 0; k < kParameterCount; ++k) {
      inside = inside && parameters[k] >= 0.0 &&
               parameters[k] <= axes[static_cast<std::size_t>(k)].maximum;
    }
    const double luck = random.uniform();
    if (inside) {
      const double trialCost = objective.cost(channels, parameters);
      if (luck < std::exp(0.5 * (cost - trialCost))) {
        at = trial;
        cost = trialCost;
      }
    }
    sum += (at - start).square();
  }
  return (sum / steps).sqrt();
}

class PosteriorTest : public QObject {
  Q_OBJECT

 private slots:
  // Little noise: a normal curve, the inverse of the normal matrix.
  void normalWhereTheDataDecide() {
    for (const bool log : {true, false}) {
      const Fitted fitted(priorOfKind(log), {1e-5, 5e-4},
                          drawPopulation(protocolPopulation(), 200, 9));
      const test::Objective objective = fitted.objective();
      double worst = 0.0;
      int compared = 0;
      for (std::size_t i = 0; i < fitted.pixels.count; ++i) {
        const ParameterVector at = fitted.solutions.at(i);
        if ((at < 1e-6).any()) continue;  // no derivative there
        const Covariance covariance = objective.covariance(fitted.pixels.at(i), at);
        for (int k = 0; k < kParameterCount; ++k) {
          const double expected = std::sqrt(covariance(k, k));
          const double whole =
              fitted.prior.isLog(k)
                  ? 1.0
                  : test::li2024().profile().axes[static_cast<std::size_t>(k)].maximum;
          if (meetsTheBox(fitted, at, expected, k) || expected > 0.03 * whole) continue;
          worst = std::max(worst, std::abs(fitted.deviation(i, k) / expected - 1.0));
          ++compared;
        }
      }
      qInfo("%s prior: %d deviations within %.2g", log ? "log" : "linear", compared, worst);
      QVERIFY(compared > 50);
      EXPECT_AT_MOST(worst, 0.03);
    }
  }

  // What is known of so few pixels is far from normal; a walk through it knows.
  void followsThePosteriorElsewhere() {
    constexpr int kWalks = 24, kSteps = 20000;
    for (const bool log : {true, false}) {
      const Prior prior = priorOfKind(log);
      const Fitted fitted(prior, test::monitorRig().noise,
                          drawFromPrior(prior, test::li2024().profile().axes, kWalks, 12));
      const test::Objective objective = fitted.objective();
      std::vector<double> ratios;
      for (std::size_t i = 0; i < kWalks; ++i) {
        const ParameterVector at = fitted.solutions.at(i).max(1e-6);
        const ParameterVector walked = walkedSpread(objective, fitted.pixels.at(i), at, kSteps, i);
        for (int k = 0; k < kParameterCount; ++k) {
          ratios.push_back(std::abs(std::log(fitted.deviation(i, k) / walked[k])));
        }
      }
      std::sort(ratios.begin(), ratios.end());
      const double median = ratios[ratios.size() / 2];
      const double most = ratios[ratios.size() * 9 / 10];
      qInfo("%s prior: |ln ratio| to the walk: median %.2g, 90 %% %.2g, worst %.2g",
            log ? "log" : "linear", median, most, ratios.back());
      EXPECT_AT_MOST(median, 0.12);
      EXPECT_AT_MOST(most, 0.4);
    }
  }

  // Along a line of skins from one corner of the ranges to the other.
  void staysWithinTheRangeAndIsSmooth() {
    constexpr std::size_t kTones = 500;
    const auto& axes = test::li2024().profile().axes;
    std::vector<ParameterVector> people;
    for (std::size_t i = 0; i < kTones; ++i) {
      ParameterVector person;
      for (int k = 0; k < kParameterCount; ++k) {
        // From a skin that there is to one that there is not; a logarithm bends where its line
        // begins at 0.
        const double share = 0.05 + 0.949 * static_cast<double>(i) / (kTones - 1.0);
        person[k] = axes[static_cast<std::size_t>(k)].maximum * share * share;
      }
      people.push_back(person);
    }
    const test::PixelSet pixels = test::simulate(test::monitorRig(), people, 0.0);
    for (const bool log : {true, false}) {
      FitOptions options;
      options.prior = priorOfKind(log);
      const auto solver = makeRefinedSolver(test::sharedModel(), test::monitorRig(), options);
      PixelBuffer<float> values(kParameterCount, kTones), deviations(kParameterCount, kTones);
      for (std::size_t i = 0; i < kTones; ++i) {
        for (int k = 0; k < kParameterCount; ++k)
          values[static_cast<std::size_t>(k)][i] = static_cast<float>(people[i][k]);
      }
      solver->deviations(pixels.rows(), values.rows(), deviations.rows());
      for (std::size_t k = 0; k < kParameterCount; ++k) {
        const double maximum = axes[k].maximum;
        double roughest = 0.0;
        for (std::size_t i = 0; i < kTones; ++i) {
          const double away = double{values[k][i]} - 0.5 * maximum;
          const double flat = std::sqrt(maximum * maximum / 12.0 + away * away);
          QVERIFY(double{deviations[k][i]} <= flat * 1.00001);
          if (i < 2) continue;
          const double bend = std::log(double{deviations[k][i]}) -
                              2.0 * std::log(double{deviations[k][i - 1]}) +
                              std::log(double{deviations[k][i - 2]});
          roughest = std::max(roughest, std::abs(bend));
        }
        qInfo("%s prior, parameter %zu: steps bend by %.2g", log ? "log" : "linear", k, roughest);
        EXPECT_AT_MOST(roughest, 0.02);
      }
    }
  }

  // Two deviations hold the truth as often as they should, when people are what the prior says.
  void coversTheTruth() {
    constexpr int kPeople = 20000;
    constexpr std::size_t kFewest = 1000;  // of a cell to judge: ±0.7 % at one standard error
    for (const bool log : {true, false}) {
      const Prior prior = priorOfKind(log);
      const auto people = drawFromPrior(prior, test::li2024().profile().axes, kPeople, 4);
      const Fitted fitted(prior, test::monitorRig().noise, people);
      const Coverage coverage =
          coverageOf(people, fitted.solutions.parameters, fitted.deviations, prior);
      for (std::size_t k = 0; k < kParameterCount; ++k) {
        const Coverage::Count measured = coverage.measured[k], assumed = coverage.assumed[k];
        qInfo("%s prior, parameter %zu: %.1f %% of %zu measured, %.1f %% of %zu elsewhere",
              log ? "log" : "linear", k, 100.0 * measured.share(), measured.pixels,
              100.0 * assumed.share(), assumed.pixels);
        if (measured.pixels >= kFewest) {
          QVERIFY(measured.share() >= 0.93 && measured.share() <= 0.97);
        }
        if (assumed.pixels >= kFewest) QVERIFY(assumed.share() >= 0.93);
      }
    }
  }
};

CUTIS_TEST(PosteriorTest)

}  // namespace
}  // namespace cutis

#include "posterior_test.moc"
