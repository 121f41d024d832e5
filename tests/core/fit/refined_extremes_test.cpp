// Pixels that are no skin, and options at their ends: the answer is finite and inside the box.

#include <algorithm>
#include <cmath>
#include <limits>

#include <QtTest>

#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "core/fit/population.h"
#include "core/fit/refined/refined_solver.h"
#include "core/skin/pixel_state.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

test::PixelSet oddPixels(std::size_t channelCount) {
  const float huge = 1e6f;
  const float all[] = {0.0f, 1e-40f, 1e-20f, 1e-6f, 1.0f, 5.0f, huge, 1e18f, 3e38f};
  std::vector<std::vector<float>> pixels;
  for (const float value : all)
    pixels.emplace_back(channelCount, value);  // black … blinding
  for (const float value : all) {              // one channel stands out
    for (std::size_t k = 0; k < channelCount; ++k) {
      pixels.emplace_back(channelCount, 0.3f);
      pixels.back()[k] = value;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {  // pure red, green, blue
    pixels.emplace_back(channelCount, 0.0f);
    for (std::size_t k = c; k < channelCount; k += 3)
      pixels.back()[k] = 1.0f;
  }
  const float contradictory[] = {0.0f, 1.0f, 5.0f, huge};
  Random random(21);
  for (int i = 0; i < 400; ++i) {
    pixels.emplace_back();
    for (std::size_t k = 0; k < channelCount; ++k) {
      pixels.back().push_back(i < 200 ? contradictory[static_cast<int>(random.uniform(0.0, 4.0))]
                                      : static_cast<float>(random.uniform(0.0, 1.2)));
    }
  }
  return test::pixelsOf(pixels);
}

// Finite, in the box, and a state that a fit may give.
bool wellBehaved(const test::Solutions& solutions, std::size_t i) {
  const ParameterVector p = solutions.at(i);
  bool good = hasEstimate(solutions.states[i]);
  for (int k = 0; k < kParameterCount; ++k) {
    // A float next to the bound may round to just beyond it.
    const double maximum = test::li2024().profile().axes[std::size_t(k)].maximum;
    good = good && std::isfinite(p[k]) && p[k] >= 0.0 && p[k] <= maximum * (1.0 + 1e-5);
  }
  return good;
}

Rig aliveAndDead() {
  Rig rig = test::monitorRig();
  rig.camera.sensor.sensitivity.row(1).setZero();
  return rig;
}

void expectGoodAnswers(const PixelSolver& solver, const test::PixelSet& pixels,
                       const char* instructionSet) {
  test::Solutions solutions = test::solve(solver, pixels);
  for (std::size_t i = 0; i < pixels.count; ++i) {
    QVERIFY2(wellBehaved(solutions, i), qPrintable(QString("%1, pixel %2: %3 %4 %5 %6 %7, state %8")
                                                       .arg(instructionSet)
                                                       .arg(i)
                                                       .arg(solutions.at(i)[0])
                                                       .arg(solutions.at(i)[1])
                                                       .arg(solutions.at(i)[2])
                                                       .arg(solutions.at(i)[3])
                                                       .arg(solutions.at(i)[4])
                                                       .arg(storedState(solutions.states[i]))));
  }
  std::vector<float> deviations(solutions.parameters.size(), -1.0f);
  solver.deviations(pixels.rows(), solutions.rows(),
                    packedRows(deviations.data(), kParameterCount, pixels.count));
  for (const float value : deviations) {
    QVERIFY2(std::isfinite(value) && value >= 0.0f, instructionSet);
  }
}

class RefinedExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { EXPECT_OK(pinInstructionSet("")); }

  void staysFiniteAndInsideTheBox_data() {
    QTest::addColumn<bool>("log");
    QTest::addColumn<double>("read");
    QTest::addColumn<double>("proportional");
    for (const bool log : {true, false}) {
      const char* prior = log ? "log" : "linear";
      QTest::addRow("%s", prior) << log << 0.0001 << 0.005;
      QTest::addRow("%s, no read noise", prior) << log << 0.0 << 0.005;
      QTest::addRow("%s, read noise only", prior) << log << 0.001 << 0.0;
      QTest::addRow("%s, exact", prior) << log << 0.0 << 0.0;
      QTest::addRow("%s, hardly any", prior) << log << 1e-9 << 1e-9;
    }
  }
  void staysFiniteAndInsideTheBox() {
    QFETCH(bool, log);
    QFETCH(double, read);
    QFETCH(double, proportional);
    FitOptions options;
    options.noise = NoiseModel{read, proportional};
    if (!log) options.prior = test::populationPrior();
    for (const Rig& rig : {test::monitorRig(), test::albedoRig(), aliveAndDead()}) {
      const auto solver = makeRefinedSolver(test::sharedModel(), rig, options);
      const test::PixelSet pixels = oddPixels(static_cast<std::size_t>(rig.channelCount()));
      for (const char* instructionSet : {"scalar", "sse4", "avx2", "avx512"}) {
        if (!pinInstructionSet(instructionSet)) continue;  // not on this processor
        expectGoodAnswers(*solver, pixels, instructionSet);
        if (QTest::currentTestFailed()) return;
      }
    }
  }

  // The exact setting on noisy channels meets them as well as the truth does, if not better.
  void exactSettingOnNoisyChannels() {
    const auto people = drawPopulation(protocolPopulation(), 500, 24);
    const test::PixelSet pixels = test::simulate(test::monitorRig(), people, 0.005);
    FitOptions options;
    options.noise = NoiseModel{0.0, 0.0};
    const auto solver = makeRefinedSolver(test::sharedModel(), test::monitorRig(), options);
    test::Solutions solutions = test::solve(*solver, pixels);
    test::Solutions truth = solutions;
    for (std::size_t i = 0; i < pixels.count; ++i) {
      for (std::size_t k = 0; k < kParameterCount; ++k) {
        truth.parameters[k * pixels.count + i] = static_cast<float>(people[i][static_cast<int>(k)]);
      }
    }
    const auto squares = [&](test::Solutions& at) {
      std::vector<float> residuals(pixels.channels.size());
      solver->residuals(pixels.rows(), at.rows(),
                        packedRows(residuals.data(), pixels.channelCount(), pixels.count));
      std::vector<double> sums(pixels.count, 0.0);
      for (std::size_t i = 0; i < residuals.size(); ++i) {
        sums[i % pixels.count] += double{residuals[i]} * double{residuals[i]};
      }
      return sums;
    };
    const std::vector<double> reached = squares(solutions), possible = squares(truth);
    std::size_t asWell = 0;
    for (std::size_t i = 0; i < pixels.count; ++i) {
      if (reached[i] <= possible[i]) ++asWell;
    }
    QVERIFY2(asWell >= pixels.count * 99 / 100, std::to_string(asWell).c_str());
  }

  // Three channels for five parameters, and no noise: the prior decides among all that meet them.
  void exactSettingWithFewChannels() {
    const auto people = drawPopulation(protocolPopulation(), 500, 25);
    const test::PixelSet pixels = test::simulate(test::albedoRig(), people, 0.0);
    FitOptions options;
    options.noise = NoiseModel{0.0, 0.0};
    const auto solver = makeRefinedSolver(test::sharedModel(), test::albedoRig(), options);
    test::Solutions solutions = test::solve(*solver, pixels);
    std::vector<float> residuals(pixels.channels.size());
    solver->residuals(pixels.rows(), solutions.rows(),
                      packedRows(residuals.data(), pixels.channelCount(), pixels.count));
    int unsolved = 0, far = 0;
    for (const PixelState state : solutions.states)
      unsolved += state == PixelState::solved ? 0 : 1;
    for (const float residual : residuals)
      far += std::abs(residual) > 1e-5f ? 1 : 0;
    EXPECT_AT_MOST(unsolved, 5);
    EXPECT_AT_MOST(far, 10);
  }

  void fixedParametersAreExact_data() {
    QTest::addColumn<bool>("log");
    QTest::addColumn<bool>("exact");
    for (const bool log : {true, false}) {
      QTest::newRow(log ? "log" : "linear") << log << false;
      QTest::newRow(log ? "log, exact" : "linear, exact") << log << true;
    }
  }
  void fixedParametersAreExact() {
    QFETCH(bool, log);
    QFETCH(bool, exact);
    // The ends of the ranges are the hard ones: there is no logarithm of 0.
    for (int fixed = 0; fixed < kParameterCount; ++fixed) {
      for (const double share : {0.0, fixed % 2 == 0 ? 1.0 : 0.123456789}) {
        FitOptions options;
        if (!log) options.prior = test::populationPrior();
        if (exact) options.noise = NoiseModel{0.0, 0.0};
        const auto index = static_cast<std::size_t>(fixed);
        const double value = share * test::li2024().profile().axes[index].maximum;
        options.fixed[index] = value;
        const auto solver = makeRefinedSolver(test::sharedModel(), test::monitorRig(), options);
        const test::PixelSet pixels = oddPixels(9);
        const test::Solutions solutions = test::solve(*solver, pixels);
        std::vector<float> deviations(solutions.parameters.size(), -1.0f);
        solver->deviations(pixels.rows(), solutions.rows(),
                           packedRows(deviations.data(), kParameterCount, pixels.count));
        for (std::size_t i = 0; i < pixels.count; ++i) {
          QVERIFY(wellBehaved(solutions, i));
          QCOMPARE(solutions.parameters[index * pixels.count + i], static_cast<float>(value));
          QCOMPARE(deviations[index * pixels.count + i], 0.0f);
        }
      }
    }
  }

  void allParametersMayBeFixed() {
    FitOptions options;
    const ParameterVector known = {0.05, 0.5, 0.02, 0.01, 0.0};
    for (std::size_t k = 0; k < kParameterCount; ++k)
      options.fixed[k] = known[Eigen::Index(k)];
    const auto solver = makeRefinedSolver(test::sharedModel(), test::monitorRig(), options);
    const test::Solutions solutions = test::solve(*solver, oddPixels(9));
    for (std::size_t i = 0; i < solutions.states.size(); ++i) {
      QVERIFY(((solutions.at(i) - known).abs() < 1e-8).all());
    }
  }

  // A camera that sees nothing at all: what remains is the prior.
  void aBlindRigGivesThePrior() {
    Rig rig = test::albedoRig();
    rig.camera.sensor.sensitivity.setZero();
    const auto solver = makeRefinedSolver(test::sharedModel(), rig, {});
    const test::Solutions solutions =
        test::solve(*solver, test::pixelsOf({{0.2f, 0.3f, 0.4f}, {0.0f, 0.0f, 0.0f}}));
    const Prior& prior = test::li2024().profile().prior;
    for (std::size_t i = 0; i < 2; ++i) {
      for (int k = 0; k < kParameterCount; ++k) {
        EXPECT_NEAR(solutions.at(i)[k] / prior.mean[k], 1.0, 0.2 * prior.deviation[k]);
      }
    }
  }

  // The rig has as many channels as a rig may have.
  void theLargestRigFits() {
    Rig rig = test::monitorRig();
    while (rig.lights.size() < kMaximumLights) {
      rig.lights.push_back(rig.lights[rig.lights.size() % 3]);
      rig.lights.back().name += std::to_string(rig.lights.size());
    }
    EXPECT_OK(validate(rig, "rig.json"));
    const auto solver = makeRefinedSolver(test::sharedModel(), rig, {});
    const auto people = drawPopulation(protocolPopulation(), 100, 23);
    const test::Solutions solutions = test::solve(*solver, test::simulate(rig, people, 0.005));
    double error = 0.0;
    for (std::size_t i = 0; i < people.size(); ++i) {
      error += test::visibleError(people[i], solutions.at(i)) / 100.0;
    }
    EXPECT_AT_MOST(error, 1e-5);
  }

  void noPixelsAreNoWork() {
    const auto solver = makeRefinedSolver(test::sharedModel(), test::albedoRig(), {});
    solver->solve({}, {}, {});
    solver->deviations({}, {}, {});
  }
};

CUTIS_TEST(RefinedExtremesTest)

}  // namespace
}  // namespace cutis

#include "refined_extremes_test.moc"
