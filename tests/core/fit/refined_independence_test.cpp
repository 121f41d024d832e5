// A pixel's result is a function of its own channels alone: the same bytes wherever it stands.

#include <algorithm>
#include <cstring>
#include <numeric>

#include <QtTest>

#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "core/fit/population.h"
#include "core/fit/refined/refined_solver.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// Ordinary pixels with hard ones between them, so that some lanes need many rounds.
test::PixelSet mixedPixels(std::size_t count) {
  test::PixelSet pixels = test::simulate(
      test::monitorRig(), drawPopulation(protocolPopulation(), static_cast<int>(count), 13), 0.005);
  Random random(14);
  for (std::size_t i = 0; i < count; i += 7) {
    for (std::size_t k = 0; k < 9; ++k) {
      pixels.channels[k * count + i] = static_cast<float>(random.uniform(0.0, 1.5));
    }
  }
  return pixels;
}

test::PixelSet pick(const test::PixelSet& from, const std::vector<std::size_t>& order) {
  test::PixelSet pixels;
  pixels.count = order.size();
  for (std::size_t k = 0; k < from.channelCount(); ++k) {
    for (const std::size_t i : order)
      pixels.channels.push_back(from.channels[k * from.count + i]);
  }
  return pixels;
}

// Bits of everything the solver says about a pixel.
struct Answer {
  std::array<float, kParameterCount> parameters;
  PixelState state = PixelState::masked;
  std::uint16_t iterations;
};
Answer answerOf(const test::Solutions& solutions, std::size_t i) {
  Answer answer = {};
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    answer.parameters[k] = solutions.parameters[k * solutions.states.size() + i];
  }
  answer.state = solutions.states[i];
  answer.iterations = solutions.iterations[i];
  return answer;
}
bool same(const Answer& a, const Answer& b) {
  return std::memcmp(a.parameters.data(), b.parameters.data(), sizeof a.parameters) == 0 &&
         a.state == b.state && a.iterations == b.iterations;
}

class RefinedIndependenceTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { EXPECT_OK(pinInstructionSet("")); }

  void everyInstructionSet() {
    QTest::addColumn<QString>("instructionSet");
    QTest::addColumn<bool>("exact");
    for (const char* name : {"scalar", "sse4", "avx2", "avx512"}) {
      QTest::addRow("%s", name) << name << false;
      QTest::addRow("%s, exact", name) << name << true;
    }
  }

  void anyOrderAndBatchGivesTheSameBytes_data() { everyInstructionSet(); }
  void anyOrderAndBatchGivesTheSameBytes() {
    QFETCH(QString, instructionSet);
    QFETCH(bool, exact);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    FitOptions options;
    if (exact) options.noise = NoiseModel{0.0, 0.0};
    const auto solver = makeRefinedSolver(test::sharedModel(), test::monitorRig(), options);
    constexpr std::size_t kCount = 700;
    const test::PixelSet pixels = mixedPixels(kCount);
    const test::Solutions together = test::solve(*solver, pixels);

    Random random(15);
    for (int turn = 0; turn < 6; ++turn) {
      std::vector<std::size_t> order(kCount);
      std::iota(order.begin(), order.end(), std::size_t{0});
      for (std::size_t i = kCount - 1; i > 0; --i) {
        std::swap(order[i], order[static_cast<std::size_t>(random.uniform() * double(i + 1))]);
      }
      const test::Solutions shuffled = test::solve(*solver, pick(pixels, order));
      for (std::size_t i = 0; i < kCount; ++i) {
        QVERIFY(same(answerOf(shuffled, i), answerOf(together, order[i])));
      }
    }
    for (std::size_t size = 1; size < 40; size += size < 20 ? 1 : 7) {
      for (std::size_t begin = 0; begin < 120; begin += size) {
        std::vector<std::size_t> part(size);
        std::iota(part.begin(), part.end(), begin);
        const test::Solutions alone = test::solve(*solver, pick(pixels, part));
        for (std::size_t i = 0; i < size; ++i) {
          QVERIFY(same(answerOf(alone, i), answerOf(together, begin + i)));
        }
      }
    }
  }

  // What stands beside a pixel, even if it is not a number, stays there.
  void neighboursDoNotLeak_data() { everyInstructionSet(); }
  void neighboursDoNotLeak() {
    QFETCH(QString, instructionSet);
    QFETCH(bool, exact);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    FitOptions options;
    if (exact) options.noise = NoiseModel{0.0, 0.0};
    const auto solver = makeRefinedSolver(test::sharedModel(), test::monitorRig(), options);
    constexpr std::size_t kCount = 64;
    const test::PixelSet clean = mixedPixels(kCount);
    test::PixelSet spoiled = clean;
    const std::array<float, 4> poison = {std::numeric_limits<float>::quiet_NaN(),
                                         std::numeric_limits<float>::infinity(), -1e30f, 3e38f};
    for (std::size_t i = 0; i < kCount; i += 3) {
      for (std::size_t k = 0; k < 9; ++k)
        spoiled.channels[k * kCount + i] = poison[i / 3 % 4];
    }
    const test::Solutions a = test::solve(*solver, clean);
    const test::Solutions b = test::solve(*solver, spoiled);
    for (std::size_t i = 0; i < kCount; ++i) {
      if (i % 3 != 0) QVERIFY(same(answerOf(a, i), answerOf(b, i)));
      for (const float value : answerOf(b, i).parameters)
        QVERIFY(std::isfinite(value));
    }
  }

  // resources/manual/fitting.md: across instruction sets reflectances agree within 1e-6; weakly
  // determined parameters may differ by a trace of their deviation.
  void instructionSetsAgree() {
    const test::PixelSet pixels =
        test::simulate(test::monitorRig(), drawPopulation(protocolPopulation(), 500, 16), 0.005);
    FitOptions options;
    EXPECT_OK(pinInstructionSet("avx2"));
    const auto solver = makeRefinedSolver(test::sharedModel(), test::monitorRig(), options);
    const test::Solutions wide = test::solve(*solver, pixels);
    for (const char* name : {"scalar", "sse4"}) {
      if (!pinInstructionSet(name)) continue;
      const test::Solutions narrow = test::solve(*solver, pixels);
      std::vector<double> errors;
      for (std::size_t i = 0; i < pixels.count; ++i) {
        errors.push_back(std::sqrt(test::visibleError(wide.at(i), narrow.at(i))));
      }
      std::sort(errors.begin(), errors.end());
      qInfo("%s against avx2, rms reflectance: median %.2g, 99 %% %.2g, worst %.2g", name,
            errors[250], errors[495], errors.back());
      EXPECT_AT_MOST(errors[250], 1e-6);
      EXPECT_AT_MOST(errors[495], 1e-4);
    }
  }

  void onlyTheirOwnPixelsAreWritten() {
    const auto solver = makeRefinedSolver(test::sharedModel(), test::monitorRig(), {});
    const test::PixelSet pixels = mixedPixels(50);
    std::vector<float> parameters(kParameterCount * 50, -7.0f);
    std::vector<PixelState> states(50, PixelState::saturated);
    std::vector<std::uint16_t> iterations(50, 999);
    solver->solve(pixels.rows().part(5, 13),
                  packedRows(parameters.data(), kParameterCount, 50).part(5, 13),
                  {states.data() + 5, iterations.data() + 5});
    for (std::size_t i = 0; i < 50; ++i) {
      const bool inside = i >= 5 && i < 18;
      for (std::size_t k = 0; k < kParameterCount; ++k) {
        QCOMPARE(parameters[k * 50 + i] == -7.0f, !inside);
      }
      QCOMPARE(states[i] == PixelState::saturated, !inside);
      QCOMPARE(iterations[i] == 999, !inside);
    }
  }
};

CUTIS_TEST(RefinedIndependenceTest)

}  // namespace
}  // namespace cutis

#include "refined_independence_test.moc"
