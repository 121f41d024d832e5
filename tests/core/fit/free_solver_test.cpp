// Constants found per pixel: round trips through simulated captures under many lights.

#include "core/fit/free/free_solver.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QtTest>

#include "core/fit/free/free_prior.h"
#include "core/fit/refined/refined_solver.h"
#include "tests/core/fit/many_light_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::Person;

constexpr NoiseModel kExact = {0.0, 0.0};
constexpr NoiseModel kUsual = {0.0, 0.005};

std::unique_ptr<const PixelSolver> freeSolverOf(const SkinModel& model, const FreeConstants& free,
                                                const NoiseModel& noise) {
  FitOptions options;
  options.free = free;
  options.noise = noise;
  const std::shared_ptr<const SkinModel> shared = {std::shared_ptr<const SkinModel>(), &model};
  return makeFreeSolver(shared, test::manyLightRig(), options, {}).value();
}

// Pixels with as many values as the solver has.
struct Found {
  Found(const PixelSolver& solver, const test::PixelSet& pixels)
      : count(pixels.count),
        values(solver.valueCount() * count),
        deviations(values.size()),
        residuals(pixels.channels.size()),
        states(count, PixelState::masked),
        iterations(count) {
    const auto rowsOf = [&](std::vector<float>& of) {
      return packedRows(of.data(), of.size() / count, count);
    };
    solver.solve(pixels.rows(), rowsOf(values), {states.data(), iterations.data()});
    solver.deviations(pixels.rows(), rowsOf(values), rowsOf(deviations));
    solver.residuals(pixels.rows(), rowsOf(values), rowsOf(residuals));
  }

  double value(int k, std::size_t i) const {
    return double{values[static_cast<std::size_t>(k) * count + i]};
  }
  double deviation(int k, std::size_t i) const {
    return double{deviations[static_cast<std::size_t>(k) * count + i]};
  }

  std::size_t count;
  std::vector<float> values, deviations, residuals;
  std::vector<PixelState> states;
  std::vector<std::uint16_t> iterations;
};

// A person's value k.
double truthOf(const Person& person, const FreeConstants& free, int k) {
  if (k < kParameterCount) return person.parameters[k];
  return person.constants[k == kParameterCount && free.oxygenation ? kOxygenation : kThickness];
}

// Errors of value k, of a thickness relative to it, sorted.
std::vector<double> errorsOf(const Found& found, const std::vector<Person>& people,
                             const FreeConstants& free, int k) {
  const bool relative = k > kParameterCount || !free.oxygenation;
  std::vector<double> errors;
  for (std::size_t i = 0; i < people.size(); ++i) {
    const double truth = truthOf(people[i], free, k);
    errors.push_back(std::abs(found.value(k, i) - truth) / (relative ? truth : 1.0));
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

void addCases() {
  QTest::addColumn<QString>("profile");
  QTest::addColumn<bool>("oxygenation");
  QTest::addColumn<bool>("thickness");
  for (const char* profile : {"li2024", "skin2026"}) {
    QTest::addRow("%s, oxygenation", profile) << profile << true << false;
    QTest::addRow("%s, thickness", profile) << profile << false << true;
    QTest::addRow("%s, both", profile) << profile << true << true;
  }
}

class FreeSolverTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void findsConstantsWithoutNoise_data() { addCases(); }
  void findsConstantsWithoutNoise() {
    QFETCH(QString, profile);
    QFETCH(bool, oxygenation);
    QFETCH(bool, thickness);
    const FreeConstants free = {oxygenation, thickness};
    const auto model = test::profileModel(profile.toStdString());
    const auto people = test::crowd(*model, free, 200);
    const auto solver = freeSolverOf(*model, free, kExact);
    EXPECT_AT_MOST(solver->nodes().rmsError, 1.5e-6);
    const Found found(*solver, test::photographCrowd(*model, test::manyLightRig(), people, 0.0));
    for (int k = kParameterCount; k < static_cast<int>(solver->valueCount()); ++k) {
      const std::vector<double> errors = errorsOf(found, people, free, k);
      qInfo("%s: value %d within %.2g in the median, %.2g in 95 of 100", QTest::currentDataTag(), k,
            errors[100], errors[190]);
      EXPECT_AT_MOST(errors[100], 1e-3);
      EXPECT_AT_MOST(errors[190], 1e-2);
    }
    std::vector<float> residuals = found.residuals;
    for (float& residual : residuals)
      residual = std::abs(residual);
    std::sort(residuals.begin(), residuals.end());
    EXPECT_AT_MOST(residuals[residuals.size() * 99 / 100], 1e-4f);
    EXPECT_AT_MOST(residuals.back(), 1e-3f);
  }

  void deviationsHoldUnderNoise_data() { addCases(); }
  void deviationsHoldUnderNoise() {
    QFETCH(QString, profile);
    QFETCH(bool, oxygenation);
    QFETCH(bool, thickness);
    const FreeConstants free = {oxygenation, thickness};
    const auto model = test::profileModel(profile.toStdString());
    const auto people = test::crowd(*model, free, 1000);
    const auto solver = freeSolverOf(*model, free, kUsual);
    const Found found(*solver, test::photographCrowd(*model, test::manyLightRig(), people, 0.005));
    QVERIFY(std::ranges::all_of(found.states,
                                [](PixelState state) { return state == PixelState::solved; }));
    for (int k = 0; k < static_cast<int>(solver->valueCount()); ++k) {
      int inside = 0;
      for (std::size_t i = 0; i < people.size(); ++i) {
        const double error = found.value(k, i) - truthOf(people[i], free, k);
        inside += std::abs(error) <= 2.0 * found.deviation(k, i) ? 1 : 0;
      }
      const std::vector<double> errors = errorsOf(found, people, free, k);
      qInfo(
          "%s: value %d within %.2g in the median, %.2g in 95 of 100; two deviations hold %.1f %%",
          QTest::currentDataTag(), k, errors[500], errors[950], 0.1 * inside);
      // Thicknesses are spread evenly and oxygenations wider than the prior says.
      QVERIFY2(inside >= (k < kParameterCount ? 885 : 915) && inside <= 985,
               qPrintable(QString("value %1: %2 of 1000").arg(k).arg(inside)));
    }
  }

  // Skin that has the profile's constants gives nearly the fit of five.
  void agreesWithTheFitOfFive() {
    for (const char* name : {"li2024", "skin2026"}) {
      const auto model = test::profileModel(name);
      const auto people = test::crowd(*model, {}, 300);
      const auto pixels =
          test::photographCrowd(*model, test::manyLightRig(), people, kUsual.proportional);
      const FreeConstants free = {true, true};
      const Found found(*freeSolverOf(*model, free, kUsual), pixels);
      FitOptions options;
      options.noise = kUsual;
      const auto five =
          test::solve(*makeRefinedSolver(model, test::manyLightRig(), options), pixels);
      const FreePrior prior = usualFreePrior(model->profile());
      for (int k = 0; k < 7; ++k) {
        std::vector<double> away;
        for (std::size_t i = 0; i < people.size(); ++i) {
          const double expected =
              k < kParameterCount ? double{five.parameters[static_cast<std::size_t>(k) * 300 + i]}
                                  : prior.mean[kSkinConstants[static_cast<std::size_t>(k - 5)]];
          away.push_back(std::abs(found.value(k, i) - expected) / found.deviation(k, i));
        }
        std::sort(away.begin(), away.end());
        EXPECT_AT_MOST(away[150], 1.0);
        EXPECT_AT_MOST(away[285], 2.2);
      }
    }
  }

  void aResultIsItsOwnPixelsAlone() {
    const auto model = test::profileModel("skin2026");
    const FreeConstants free = {true, false};
    const auto people = test::crowd(*model, free, 150);
    const auto pixels =
        test::photographCrowd(*model, test::manyLightRig(), people, kUsual.proportional);
    const auto solver = freeSolverOf(*model, free, kUsual);
    const Found together(*solver, pixels);
    for (const std::size_t i : {0U, 63U, 64U, 149U}) {
      test::PixelSet one;
      one.count = 1;
      for (std::size_t k = 0; k < pixels.channelCount(); ++k)
        one.channels.push_back(pixels.channels[k * pixels.count + i]);
      const Found alone(*solver, one);
      for (int k = 0; k < 6; ++k) {
        QVERIFY(alone.value(k, 0) == together.value(k, i));
        QVERIFY(alone.deviation(k, 0) == together.deviation(k, i));
      }
    }
  }

  void heldParametersStay() {
    const auto model = test::profileModel("li2024");
    const FreeConstants free = {true, false};
    const auto people = test::crowd(*model, free, 20);
    const auto pixels =
        test::photographCrowd(*model, test::manyLightRig(), people, kUsual.proportional);
    FitOptions options;
    options.free = free;
    options.noise = kUsual;
    options.fixed[kCarotene] = 0.0;
    options.fixed[kMelaninBlend] = 0.4;
    const auto solver = makeFreeSolver(model, test::manyLightRig(), options, {}).value();
    const Found found(*solver, pixels);
    for (std::size_t i = 0; i < people.size(); ++i) {
      QCOMPARE(found.value(kCarotene, i), 0.0);
      EXPECT_NEAR(found.value(kMelaninBlend, i), 0.4, 1e-7);
      QCOMPARE(found.deviation(kCarotene, i), 0.0);
    }
  }

  // Whatever the channels are: an answer within the ranges.
  void strangePixelsStayWithinTheRanges() {
    const auto model = test::profileModel("skin2026");
    const ThicknessRange range = thicknessRange(model->profile()).value();
    std::vector<std::vector<float>> strange;
    for (const float value : {1e-6f, 0.5f, 1.0f, 4.0f, 1e4f})
      strange.emplace_back(24, value);
    std::vector<float> jagged(24, 0.9f);
    for (std::size_t k = 0; k < jagged.size(); k += 2)
      jagged[k] = 0.0f;
    strange.push_back(jagged);
    for (const NoiseModel& noise : {kUsual, kExact}) {
      const auto solver = freeSolverOf(*model, {true, true}, noise);
      const Found found(*solver, test::pixelsOf(strange));
      for (std::size_t i = 0; i < strange.size(); ++i) {
        for (const Parameter k : kParameters) {
          const double maximum = model->profile().axes[k].maximum;
          QVERIFY(found.value(k, i) >= 0.0 && found.value(k, i) <= maximum * 1.000001);
        }
        QVERIFY(found.value(5, i) >= 0.0 && found.value(5, i) <= 1.0);
        QVERIFY(isPossible(kThickness, found.value(6, i)));
        EXPECT_AT_MOST(found.value(6, i), range.highMm * 1.000001);
        for (int k = 0; k < 7; ++k)
          QVERIFY(std::isfinite(found.deviation(k, i)));
      }
    }
  }

  void tooFewChannelsAreRefused() {
    FitOptions options;
    options.free = {true, true};
    EXPECT_OK(checkChannelsDecide(test::manyLightRig(), options, "--free"));
    EXPECT_OK(checkChannelsDecide(test::monitorRig(), options, "--free"));
    EXPECT_ERROR(checkChannelsDecide(test::albedoRig(), options, "--free"),
                 "3 independent channels where 7 values");
    options.fixed = {0.02, 0.5, 0.02, 0.01, std::nullopt};
    EXPECT_OK(checkChannelsDecide(test::albedoRig(), options, "--free"));
    options.fixed = {};
    // Three channels of a grey camera are one; a light twice is one; a dead channel is none.
    Rig grey = test::manyLightRig();
    grey.camera.sensor.sensitivity.row(1) = grey.camera.sensor.sensitivity.row(0);
    grey.camera.sensor.sensitivity.row(2).setZero();
    EXPECT_OK(checkChannelsDecide(grey, options, "--free"));
    grey.lights[1].power = grey.lights[0].power;
    EXPECT_OK(checkChannelsDecide(grey, options, "--free"));
    grey.lights[2].power = grey.lights[0].power;
    EXPECT_ERROR(checkChannelsDecide(grey, options, "--free"), "6 independent channels");
  }

  void aProfileBeyondTheRangeKeepsItsThickness() {
    Profile thick = test::profileModel("li2024")->profile();
    thick.epidermalThicknessMm = 0.8;
    FitOptions options;
    options.free.thickness = true;
    EXPECT_ERROR(
        makeFreeSolver(std::make_shared<const SkinModel>(thick), test::manyLightRig(), options, {}),
        "keep the thickness of this profile");
  }
};

CUTIS_TEST(FreeSolverTest)

}  // namespace
}  // namespace cutis

#include "free_solver_test.moc"
