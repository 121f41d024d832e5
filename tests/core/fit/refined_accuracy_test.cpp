// The fast solver against the plain one: the same objective, minimised as well.

#include <algorithm>
#include <cmath>

#include <QtTest>

#include "core/fit/population.h"
#include "core/fit/reference/map_estimator.h"
#include "core/fit/refined/refined_solver.h"
#include "core/skin/model/choose_nodes.h"
#include "core/skin/pixel_state.h"
#include "core/skin/profile/parameter_sampling.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kAccuracyPixels = 1000;

FitOptions optionsOf(const Prior& prior, std::optional<NoiseModel> noise = {}) {
  FitOptions options;
  options.prior = prior;
  options.noise = noise;
  return options;
}

std::unique_ptr<const PixelSolver> solverOf(const Rig& rig, const FitOptions& options) {
  return makeRefinedSolver(test::sharedModel(), rig, options);
}

class RefinedAccuracyTest : public QObject {
  Q_OBJECT

 private slots:
  void agreesWithTheReference_data() {
    QTest::addColumn<bool>("log");
    QTest::addColumn<double>("noise");
    QTest::addColumn<bool>("threeChannels");
    QTest::newRow("log prior, 0.5 %") << true << 0.005 << false;
    QTest::newRow("linear prior, 0.5 %") << false << 0.005 << false;
    QTest::newRow("log prior, 0.1 %") << true << 0.001 << false;
    QTest::newRow("linear prior, 0.1 %") << false << 0.001 << false;
    QTest::newRow("log prior, 2 %") << true << 0.02 << false;
    QTest::newRow("log prior, albedo rig") << true << 0.005 << true;
    QTest::newRow("linear prior, albedo rig") << false << 0.005 << true;
  }
  void agreesWithTheReference() {
    QFETCH(bool, log);
    QFETCH(double, noise);
    QFETCH(bool, threeChannels);
    const Rig& rig = threeChannels ? test::albedoRig() : test::monitorRig();
    const Prior prior = log ? test::li2024().profile().prior : test::populationPrior();
    const NoiseModel model = {0.0001, noise};
    const auto solver = solverOf(rig, optionsOf(prior, model));
    const test::PixelSet pixels =
        test::simulate(rig, drawPopulation(protocolPopulation(), kAccuracyPixels, 8), noise);
    const test::Solutions solutions = test::solve(*solver, pixels);

    const test::Objective objective = {
        test::li2024(), chooseNodes(test::li2024(), responseRows(rig)), prior, model};
    const MapEstimator reference(test::li2024(), objective.nodes, {prior, model, {}, 200});
    int far = 0, costly = 0, notConverged = 0;
    double worstDistance = 0.0, worstCost = 0.0;
    for (std::size_t i = 0; i < pixels.count; ++i) {
      const Estimate exact = reference.solve(pixels.at(i));
      const ParameterVector away =
          objective.coordinates(solutions.at(i)) - objective.coordinates(exact.parameters);
      const double distance = (away / exact.covariance.diagonal().array().sqrt()).abs().maxCoeff();
      const double excess = objective.cost(pixels.at(i), solutions.at(i)) - exact.cost;
      far += distance <= 0.2 ? 0 : 1;
      costly += excess <= 0.05 ? 0 : 1;
      notConverged += solutions.states[i] == PixelState::solved ? 0 : 1;
      worstDistance = std::max(worstDistance, distance);
      worstCost = std::max(worstCost, excess);
    }
    qInfo(
        "%d of %d beyond 0.2 deviations (worst %.2g), %d beyond 0.05 in cost (worst %.2g), "
        "%d without convergence",
        far, kAccuracyPixels, worstDistance, costly, worstCost, notConverged);
    EXPECT_AT_MOST(far, 0.01 * kAccuracyPixels);
    EXPECT_AT_MOST(costly, 0.01 * kAccuracyPixels);
    EXPECT_AT_MOST(notConverged, 0.001 * kAccuracyPixels);
  }

  // The whole box of the profile counts, darkest and reddest skin included.
  void agreesOverTheWholeBox() {
    const Prior prior = test::li2024().profile().prior;
    const auto solver = solverOf(test::monitorRig(), optionsOf(prior));
    const test::PixelSet pixels = test::simulate(
        test::monitorRig(), sampleBox(test::li2024().profile().axes, kAccuracyPixels), 0.005);
    const test::Solutions solutions = test::solve(*solver, pixels);
    const test::Objective objective = {
        test::li2024(), chooseNodes(test::li2024(), responseRows(test::monitorRig())), prior,
        test::monitorRig().noise};
    const MapEstimator reference(test::li2024(), objective.nodes,
                                 {prior, test::monitorRig().noise, {}, 200});
    int costly = 0;
    double worst = 0.0;
    for (std::size_t i = 0; i < pixels.count; ++i) {
      const double excess =
          objective.cost(pixels.at(i), solutions.at(i)) - reference.solve(pixels.at(i)).cost;
      costly += excess <= 0.05 ? 0 : 1;
      worst = std::max(worst, excess);
    }
    qInfo("%d of %d beyond 0.05 in cost (worst %.2g)", costly, kAccuracyPixels, worst);
    EXPECT_AT_MOST(costly, 0.01 * kAccuracyPixels);
  }

  // No noise: the channels are met to what a float can hold.
  void exactSettingMeetsTheChannels() {
    const NoiseModel none = {0.0, 0.0};
    for (const bool log : {true, false}) {
      const Prior prior = log ? test::li2024().profile().prior : test::populationPrior();
      const auto solver = solverOf(test::monitorRig(), optionsOf(prior, none));
      const auto people = drawPopulation(protocolPopulation(), 500, 10);
      const test::PixelSet pixels = test::simulate(test::monitorRig(), people);
      const test::Solutions solutions = test::solve(*solver, pixels);
      const SpectrumRows rows = responseRows(test::monitorRig());
      double worstChannel = 0.0, error = 0.0;
      for (std::size_t i = 0; i < people.size(); ++i) {
        const Eigen::VectorXd modelled =
            rows.matrix() * test::li2024().reflectance(solutions.at(i)).matrix();
        worstChannel = std::max(worstChannel, (modelled - pixels.at(i)).cwiseAbs().maxCoeff());
        error += test::visibleError(people[i], solutions.at(i)) / 500.0;
      }
      qInfo("%s prior: channels within %.2g, visible MSE %.2g", log ? "log" : "linear",
            worstChannel, error);
      EXPECT_AT_MOST(worstChannel, 2e-5);
      EXPECT_AT_MOST(error, 3e-8);
    }
  }

  void residualsAreMeasuredMinusModelled() {
    const auto solver = solverOf(test::monitorRig(), {});
    const test::PixelSet pixels =
        test::simulate(test::monitorRig(), drawPopulation(protocolPopulation(), 50, 12), 0.02);
    test::Solutions solutions = test::solve(*solver, pixels);
    std::vector<float> residuals(pixels.channels.size());
    solver->residuals(pixels.rows(), solutions.rows(),
                      packedRows(residuals.data(), pixels.channelCount(), pixels.count));
    const SpectrumRows rows = responseRows(test::monitorRig());
    for (std::size_t i = 0; i < pixels.count; ++i) {
      const Eigen::VectorXd modelled =
          rows.matrix() * test::li2024().reflectance(solutions.at(i)).matrix();
      for (std::size_t k = 0; k < 9; ++k) {
        EXPECT_NEAR(residuals[k * pixels.count + i],
                    pixels.at(i)[Eigen::Index(k)] - modelled[Eigen::Index(k)], 1e-4);
      }
    }
  }
};

CUTIS_TEST(RefinedAccuracyTest)

}  // namespace
}  // namespace cutis

#include "refined_accuracy_test.moc"
