// The prior in the coordinates of the fit, and parameters that go together.

#include "core/fit/coordinate_prior.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <QtTest>

#include "core/fit/population.h"
#include "core/fit/reference/map_estimator.h"
#include "core/fit/refined/refined_solver.h"
#include "core/skin/model/choose_nodes.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

Prior correlatedPrior() {
  Prior prior = test::li2024().profile().prior;
  const auto couple = [&](int a, int b, double r) {
    prior.correlation(a, b) = prior.correlation(b, a) = r;
  };
  couple(kMelanin, kMelaninBlend, -0.5);
  couple(kMelanin, kHaemoglobinDermal, 0.4);
  couple(kHaemoglobinEpidermal, kCarotene, 0.3);
  return prior;
}

class CoordinatePriorTest : public QObject {
  Q_OBJECT

 private slots:
  void withoutCorrelationsItIsThePrior() {
    const Prior& prior = test::li2024().profile().prior;
    const CoordinatePrior found = coordinatePrior(prior, test::li2024().profile().axes, {});
    for (int i = 0; i < kParameterCount; ++i) {
      EXPECT_NEAR(found.mean[i], prior.isLog(i) ? std::log(prior.mean[i]) : prior.mean[i], 1e-14);
      EXPECT_NEAR(found.deviation[i], prior.deviation[i], 1e-14);
      for (int j = 0; j < kParameterCount; ++j) {
        EXPECT_NEAR(found.precision(i, j),
                    i == j ? 1.0 / (prior.deviation[i] * prior.deviation[i]) : 0.0, 1e-14);
      }
    }
  }

  // Where two go together, knowing one informs of the other: μ + ρ s/s' (x' − μ'), s √(1 − ρ²).
  void heldParametersTellOfTheOthers() {
    Prior prior = test::li2024().profile().prior;
    prior.correlation(kMelanin, kMelaninBlend) = prior.correlation(kMelaninBlend, kMelanin) = -0.5;
    std::array<std::optional<double>, kParameterCount> fixed;
    fixed[kMelaninBlend] = 0.9;
    const CoordinatePrior found = coordinatePrior(prior, test::li2024().profile().axes, fixed);
    QCOMPARE(found.mean[kMelaninBlend], 0.9);
    const double away = (0.9 - prior.mean[kMelaninBlend]) / prior.deviation[kMelaninBlend];
    EXPECT_NEAR(found.mean[kMelanin],
                std::log(prior.mean[kMelanin]) - 0.5 * prior.deviation[kMelanin] * away, 1e-12);
    EXPECT_NEAR(found.deviation[kMelanin], prior.deviation[kMelanin] * std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(found.deviation[kCarotene], prior.deviation[kCarotene], 1e-12);
    QCOMPARE(found.precision(kMelanin, kMelaninBlend), 0.0);
  }

  void allParametersMayBeHeld() {
    std::array<std::optional<double>, kParameterCount> fixed;
    fixed.fill(0.001);
    const CoordinatePrior found =
        coordinatePrior(correlatedPrior(), test::li2024().profile().axes, fixed);
    for (int i = 0; i < kParameterCount; ++i)
      QCOMPARE(found.mean[i], 0.001);
  }

  // The fast fit and the plain one share the same correlated prior.
  void theFitFollowsIt() {
    const Prior prior = correlatedPrior();
    FitOptions options;
    options.prior = prior;
    const Rig& rig = test::albedoRig();
    const auto solver = makeRefinedSolver(test::sharedModel(), rig, options);
    const test::PixelSet pixels =
        test::simulate(rig, drawPopulation(protocolPopulation(), 300, 31), 0.005);
    const test::Solutions solutions = test::solve(*solver, pixels);
    const MapEstimator reference(test::li2024(), chooseNodes(test::li2024(), responseRows(rig)),
                                 {prior, rig.noise, {}, 200});
    int far = 0;
    for (std::size_t i = 0; i < pixels.count; ++i) {
      const Estimate exact = reference.solve(pixels.at(i));
      const ParameterVector away = solutions.at(i) - exact.parameters;
      far += (away.abs() > 0.25 * exact.deviations + 1e-9).any() ? 1 : 0;
    }
    EXPECT_AT_MOST(far, 9);
  }
};

CUTIS_TEST(CoordinatePriorTest)

}  // namespace
}  // namespace cutis

#include "coordinate_prior_test.moc"
