#include "core/fit/reference/map_estimator.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "core/fit/population.h"
#include "core/skin/model/choose_nodes.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const SkinModel& model() {
  return test::li2024();
}

const SpectralNodes& monitorNodes() {
  static const SpectralNodes nodes = chooseNodes(model(), responseRows(test::monitorRig()));
  return nodes;
}

// Every sample of the visible, each its own channel: a spectrometer.
SpectralNodes spectrometer() {
  SpectralNodes nodes;
  for (int i = kVisibleBand.first; i <= kVisibleBand.last; ++i)
    nodes.samples.push_back(i);
  nodes.weights = Eigen::MatrixXd::Identity(kVisibleBand.count(), kVisibleBand.count());
  return nodes;
}

EstimatorOptions withPrior(const Prior& prior, NoiseModel noise = {}) {
  EstimatorOptions options;
  options.prior = prior;
  options.noise = noise;
  return options;
}

std::vector<Prior> bothPriors() {
  return {model().profile().prior, test::populationPrior()};
}

// d cost / d coordinate by central differences.
double slope(const test::Objective& objective, const Eigen::VectorXd& channels,
             const ParameterVector& x, int i, double step) {
  ParameterVector above = x, below = x;
  above[i] += step;
  below[i] -= step;
  return (objective.cost(channels, objective.parameters(above)) -
          objective.cost(channels, objective.parameters(below))) /
         (2.0 * step);
}

class MapEstimatorTest : public QObject {
  Q_OBJECT

 private slots:
  // The minimised sum is the documented one, and at the minimum its slope is zero, or leads out of
  // the box where a coordinate is at a bound.
  void minimisesItsObjective() {
    for (const Prior& prior : bothPriors()) {
      const NoiseModel noise = {0.0001, 0.005};
      const MapEstimator estimator(model(), monitorNodes(), withPrior(prior, noise));
      const test::Objective objective = {model(), monitorNodes(), prior, noise};
      const auto people = drawPopulation(protocolPopulation(), 100, 3);
      const test::PixelSet pixels = test::simulate(test::monitorRig(), people, 0.005);
      for (std::size_t i = 0; i < people.size(); ++i) {
        const Eigen::VectorXd channels = pixels.at(i);
        const Estimate estimate = estimator.solve(channels);
        QVERIFY(estimate.converged);
        EXPECT_NEAR(estimate.cost, objective.cost(channels, estimate.parameters),
                    1e-4 * (1.0 + estimate.cost));
        const ParameterVector x = objective.coordinates(estimate.parameters);
        for (int k = 0; k < kParameterCount; ++k) {
          const double deviation = std::sqrt(estimate.covariance(k, k));
          // The slope in units of the posterior: cost per standard deviation.
          const double perDeviation =
              slope(objective, channels, x, k, 1e-4 * deviation) * deviation;
          const double maximum = model().profile().axes[std::size_t(k)].maximum;
          if (estimate.parameters[k] <= 1e-6 * maximum) {
            QVERIFY(perDeviation > -1e-3);
          } else if (estimate.parameters[k] >= maximum * (1.0 - 1e-9)) {
            QVERIFY(perDeviation < 1e-3);
          } else {
            EXPECT_NEAR(perDeviation, 0.0, 2e-3);
          }
        }
      }
    }
  }

  void covarianceIsTheInverseOfTheInformation() {
    const NoiseModel noise = {0.0001, 0.005};
    for (const Prior& prior : bothPriors()) {
      const MapEstimator estimator(model(), monitorNodes(), withPrior(prior, noise));
      const test::Objective objective = {model(), monitorNodes(), prior, noise};
      const auto people = drawPopulation(protocolPopulation(), 30, 4);
      const test::PixelSet pixels = test::simulate(test::monitorRig(), people, 0.005);
      for (std::size_t i = 0; i < people.size(); ++i) {
        const Estimate estimate = estimator.solve(pixels.at(i));
        if (((estimate.parameters < 1e-6)).any()) continue;  // no derivative there
        const auto expected = objective.covariance(pixels.at(i), estimate.parameters);
        for (int k = 0; k < kParameterCount; ++k) {
          EXPECT_NEAR(estimate.covariance(k, k) / expected(k, k), 1.0, 1e-3);
          const double unit = prior.isLog(k) ? estimate.parameters[k] : 1.0;
          EXPECT_NEAR(estimate.deviations[k], std::sqrt(expected(k, k)) * unit,
                      1e-3 * estimate.deviations[k]);
          // Data only ever add to what is known.
          QVERIFY(estimate.covariance(k, k) <= prior.deviation[k] * prior.deviation[k] * 1.000001);
        }
        QVERIFY((estimate.covariance - estimate.covariance.transpose()).norm() <
                1e-6 * estimate.covariance.norm());
      }
    }
  }

  // Without noise and prior a whole spectrum determines all parameters.
  void recoversParametersFromSpectra() {
    EstimatorOptions options;
    options.noise = {0.001, 0.0};
    const MapEstimator estimator(model(), spectrometer(), options);
    double worst = 0.0;
    for (const ParameterVector& p : drawPopulation(protocolPopulation(), 200, 5)) {
      const Eigen::VectorXd spectrum =
          model().reflectance(p).matrix().segment(kVisibleBand.first, kVisibleBand.count());
      const Estimate estimate = estimator.solve(spectrum);
      QVERIFY(estimate.converged);
      const ParameterVector range = {0.5, 1.0, 0.5, 0.3, 0.01};
      worst = std::max(worst, ((estimate.parameters - p) / range).abs().maxCoeff());
      EXPECT_AT_MOST(estimate.residual.cwiseAbs().maxCoeff(), 1e-6);
    }
    qInfo("worst parameter error %.2g of its range", worst);
    EXPECT_AT_MOST(worst, 1e-3);
  }

  void theStartDoesNotMatterWithAPrior() {
    const Prior prior = test::populationPrior();
    const MapEstimator estimator(model(), monitorNodes(), withPrior(prior));
    const auto people = drawPopulation(protocolPopulation(), 100, 6);
    const test::PixelSet pixels = test::simulate(test::monitorRig(), people, 0.005);
    for (std::size_t i = 0; i < people.size(); ++i) {
      const Estimate fromMean = estimator.solve(pixels.at(i));
      const Estimate fromTruth = estimator.solve(pixels.at(i), people[i]);
      EXPECT_NEAR(fromMean.cost, fromTruth.cost, 1e-4);
    }
  }

  void staysInItsBox() {
    const std::vector<ParameterVector> outside = {{-1, -1, -1, -1, -1}, {2, 2, 2, 2, 2}};
    const Eigen::VectorXd black = Eigen::VectorXd::Zero(9), white = Eigen::VectorXd::Ones(9);
    for (const Prior& prior : bothPriors()) {
      const MapEstimator estimator(model(), monitorNodes(), withPrior(prior));
      for (const ParameterVector& start : outside) {
        for (const Eigen::VectorXd& channels : {black, white}) {
          const Estimate estimate = estimator.solve(channels, start);
          for (int k = 0; k < kParameterCount; ++k) {
            const double maximum = model().profile().axes[std::size_t(k)].maximum;
            QVERIFY(estimate.parameters[k] >= 0.0);
            QVERIFY(estimate.parameters[k] <= maximum * (1.0 + 1e-12));
          }
        }
      }
    }
  }

  void fixedParametersStay() {
    for (const Prior& prior : bothPriors()) {
      EstimatorOptions options = withPrior(prior);
      options.fixed[kMelaninBlend] = 0.25;
      options.fixed[kCarotene] = 0.0;
      const MapEstimator estimator(model(), monitorNodes(), options);
      const test::PixelSet pixels =
          test::simulate(test::monitorRig(), {{0.05, 0.25, 0.03, 0.02, 0.0}});
      const Estimate estimate = estimator.solve(pixels.at(0));
      QCOMPARE(estimate.parameters[kMelaninBlend], 0.25);
      QCOMPARE(estimate.parameters[kCarotene], 0.0);
      QCOMPARE(estimate.deviations[kMelaninBlend], 0.0);
      QCOMPARE(estimate.deviations[kCarotene], 0.0);
      QVERIFY(estimate.covariance.row(kCarotene).isZero(0.0));
      QVERIFY(estimate.deviations[kMelanin] > 0.0);
      EXPECT_NEAR(estimate.parameters[kMelanin], 0.05, 0.01);
    }
  }

  // A channel that sees nothing neither helps nor harms, whatever was measured in it.
  void deadChannelsAreIgnored() {
    SpectralNodes nodes = monitorNodes();
    nodes.weights.conservativeResize(10, Eigen::NoChange);
    nodes.weights.row(9).setZero();
    const Prior prior = test::populationPrior();
    const MapEstimator without(model(), monitorNodes(), withPrior(prior));
    const MapEstimator with(model(), nodes, withPrior(prior));
    const test::PixelSet pixels =
        test::simulate(test::monitorRig(), {{0.05, 0.5, 0.03, 0.02, 0.001}}, 0.005);
    Eigen::VectorXd channels(10);
    for (const double dead : {0.0, 0.7, 1e6}) {
      channels << pixels.at(0), dead;
      const Estimate estimate = with.solve(channels);
      // Sums over one row more round differently.
      const ParameterVector expected = without.solve(pixels.at(0)).parameters;
      QVERIFY(((estimate.parameters - expected).abs() < 1e-7).all());
    }
  }

  void nothingMeasuredLeavesThePrior() {
    SpectralNodes nodes;
    nodes.weights = Eigen::MatrixXd::Zero(3, 0);
    for (const Prior& prior : bothPriors()) {
      const Estimate estimate =
          MapEstimator(model(), nodes, withPrior(prior)).solve(Eigen::VectorXd::Zero(3));
      for (int k = 0; k < kParameterCount; ++k) {
        EXPECT_NEAR(estimate.parameters[k], prior.mean[k], 1e-12);
        EXPECT_NEAR(std::sqrt(estimate.covariance(k, k)), prior.deviation[k], 1e-12);
      }
    }
  }

  void contradictionsStayFinite() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::vector<double>> odd = {{0, 1, 5, 1e6, 0, 1, 5, 1e6, 0},
                                            {1e6, 1e6, 1e6, 0, 0, 0, 1, 1, 1},
                                            {1e-30, 0, 0, 0, 0, 0, 0, 0, 0},
                                            {-1, -1, -1, -1, -1, -1, -1, -1, -1},
                                            {nan, 1, 1, 1, 1, 1, 1, 1, 1}};
    for (const Prior& prior : bothPriors()) {
      for (const NoiseModel& noise : {NoiseModel{}, NoiseModel{0, 0.005}, NoiseModel{0, 0}}) {
        const MapEstimator estimator(model(), monitorNodes(), withPrior(prior, noise));
        for (std::vector<double>& values : odd) {
          const Estimate estimate =
              estimator.solve(Eigen::Map<const Eigen::VectorXd>(values.data(), 9));
          QVERIFY(estimate.parameters.isFinite().all());
          QVERIFY((estimate.parameters >= 0.0).all());
        }
      }
    }
  }
};

CUTIS_TEST(MapEstimatorTest)

}  // namespace
}  // namespace cutis

#include "map_estimator_test.moc"
