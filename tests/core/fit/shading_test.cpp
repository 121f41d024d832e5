// A factor on all channels of a pixel, found together with the skin.

#include "core/fit/shading.h"

#include <algorithm>
#include <cmath>

#include <QtTest>

#include "core/base/random.h"
#include "core/fit/population.h"
#include "core/fit/refined/refined_solver.h"
#include "core/skin/model/choose_nodes.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kShadedPixels = 1000;

// Skin in light and shadow.
struct ShadedPixels {
  ShadedPixels()
      : people(drawPopulation(protocolPopulation(), kShadedPixels, 21)),
        pixels(test::simulate(test::monitorRig(), people, 0.005)) {
    Random random(22);
    for (std::size_t i = 0; i < kShadedPixels; ++i) {
      factors.push_back(std::max(0.2, 1.0 + kUsualShadingDeviation * random.normal()));
      for (std::size_t k = 0; k < pixels.channelCount(); ++k) {
        pixels.channels[k * kShadedPixels + i] *= static_cast<float>(factors.back());
      }
    }
  }

  std::vector<ParameterVector> people;
  test::PixelSet pixels;
  std::vector<double> factors;
};

std::unique_ptr<const PixelSolver> shadedSolverOf(std::optional<double> shading) {
  FitOptions options;
  options.prior = test::populationPrior();
  options.shading = shading;
  return makeRefinedSolver(test::sharedModel(), test::monitorRig(), options);
}

double rootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values)
    sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

class ShadingTest : public QObject {
  Q_OBJECT

 private slots:
  void theFactorIsTheMostProbableOne() {
    const ShadingModel model = {{0.001, 0.01}, 0.3};
    const std::vector<float> measured = {0.2f, 0.3f, 0.25f}, modelled = {0.3f, 0.42f, 0.36f};
    const auto cost = [&](double s) {
      double sum = std::pow((s - 1.0) / 0.3, 2);
      for (std::size_t k = 0; k < 3; ++k) {
        const double y = double{measured[k]};
        sum += std::pow(y - s * double{modelled[k]}, 2) / (1e-6 + 1e-4 * y * y);
      }
      return sum;
    };
    const double s = double{
        shadingFactor(model, packedRows(measured.data(), 3, 1), packedRows(modelled.data(), 3, 1))};
    QVERIFY(cost(s) < cost(s + 1e-3) && cost(s) < cost(s - 1e-3));
  }

  // Shade and melanin look much alike, so that no more can be had of nine channels.
  void findsTheShadeAndTheSkin() {
    const ShadedPixels scene;
    const auto solver = shadedSolverOf(kUsualShadingDeviation);
    test::Solutions solutions = test::solve(*solver, scene.pixels);
    std::vector<float> factors(kShadedPixels);
    solver->shading(scene.pixels.rows(), solutions.rows(), factors.data());
    const auto plain = shadedSolverOf({});
    const test::Solutions unaware = test::solve(*plain, scene.pixels);
    std::vector<double> errors, assumed;
    double spectra = 0.0, unawareSpectra = 0.0;
    for (std::size_t i = 0; i < kShadedPixels; ++i) {
      QVERIFY(solutions.states[i] == PixelState::solved);
      errors.push_back(double{factors[i]} - scene.factors[i]);
      assumed.push_back(1.0 - scene.factors[i]);
      spectra += test::visibleError(scene.people[i], solutions.at(i)) / kShadedPixels;
      unawareSpectra += test::visibleError(scene.people[i], unaware.at(i)) / kShadedPixels;
    }
    qInfo("factor: rms error %.3f of %.3f; visible MSE %.2g, %.2g without shading",
          rootMeanSquare(errors), rootMeanSquare(assumed), spectra, unawareSpectra);
    EXPECT_AT_MOST(rootMeanSquare(errors), 0.8 * rootMeanSquare(assumed));
    EXPECT_AT_MOST(spectra, 0.65 * unawareSpectra);
  }

  // The estimate is the lowest point of the cost, the factor included.
  void nothingNearbyIsBetter() {
    const ShadedPixels scene;
    const auto solver = shadedSolverOf(kUsualShadingDeviation);
    const test::Solutions solutions = test::solve(*solver, scene.pixels);
    const NoiseModel noise = test::monitorRig().noise;
    const test::Objective objective = {
        test::li2024(), chooseNodes(test::li2024(), responseRows(test::monitorRig())),
        test::populationPrior(), noise};
    const auto cost = [&](std::size_t pixel, const ParameterVector& skin) {
      const Eigen::VectorXf measured = scene.pixels.at(pixel).cast<float>();
      const Eigen::VectorXf modelled = objective.modelled(skin).cast<float>();
      const double s = double{
          shadingFactor({noise, kUsualShadingDeviation},
                        packedRows(measured.data(), static_cast<std::size_t>(measured.size()), 1),
                        packedRows(modelled.data(), static_cast<std::size_t>(measured.size()), 1))};
      double sum = std::pow((s - 1.0) / kUsualShadingDeviation, 2) +
                   ((skin - objective.prior->mean) / objective.prior->deviation).square().sum();
      for (Eigen::Index k = 0; k < measured.size(); ++k) {
        const double y = double{measured[k]};
        sum += std::pow(y - s * double{modelled[k]}, 2) /
               (noise.read * noise.read + std::pow(noise.proportional * y, 2));
      }
      return sum;
    };
    Random random(23);
    const auto& axes = test::li2024().profile().axes;
    int improved = 0;
    for (std::size_t i = 0; i < 100; ++i) {
      const ParameterVector at = solutions.at(i);
      const double lowest = cost(i, at);
      double gain = 0.0;
      for (int trial = 0; trial < 200; ++trial) {
        ParameterVector near = at;
        for (int k = 0; k < kParameterCount; ++k) {
          const double reach = 0.02 * objective.prior->deviation[k] * random.normal();
          near[k] = std::clamp(at[k] + reach, 0.0, axes[static_cast<std::size_t>(k)].maximum);
        }
        gain = std::max(gain, lowest - cost(i, near));
      }
      improved += gain > 0.1 ? 1 : 0;
    }
    EXPECT_AT_MOST(improved, 1);
  }

  // What the factor can make up for is not known of the skin.
  void deviationsKnowOfIt() {
    const ShadedPixels scene;
    const auto shaded = shadedSolverOf(kUsualShadingDeviation), plain = shadedSolverOf({});
    test::Solutions solutions = test::solve(*shaded, scene.pixels);
    std::vector<float> with(solutions.parameters.size()), without(with.size());
    shaded->deviations(scene.pixels.rows(), solutions.rows(),
                       packedRows(with.data(), kParameterCount, kShadedPixels));
    plain->deviations(scene.pixels.rows(), solutions.rows(),
                      packedRows(without.data(), kParameterCount, kShadedPixels));
    double sum = 0.0, plainSum = 0.0;
    for (std::size_t i = 0; i < kShadedPixels; ++i) {
      sum += double{with[kMelanin * kShadedPixels + i]};
      plainSum += double{without[kMelanin * kShadedPixels + i]};
    }
    QVERIFY2(sum > 1.5 * plainSum, qPrintable(QString("%1, %2").arg(sum).arg(plainSum)));
  }

  void residualsKnowOfIt() {
    const ShadedPixels scene;
    const auto solver = shadedSolverOf(kUsualShadingDeviation);
    test::Solutions solutions = test::solve(*solver, scene.pixels);
    std::vector<float> residuals(scene.pixels.channels.size());
    solver->residuals(scene.pixels.rows(), solutions.rows(),
                      packedRows(residuals.data(), scene.pixels.channelCount(), kShadedPixels));
    std::vector<double> relative;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      relative.push_back(double{residuals[i]} / double{scene.pixels.channels[i]});
    }
    EXPECT_AT_MOST(rootMeanSquare(relative), 0.006);
  }
};

CUTIS_TEST(ShadingTest)

}  // namespace
}  // namespace cutis

#include "shading_test.moc"
