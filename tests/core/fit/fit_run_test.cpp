// Which pixels of a picture are solved, how often, and what is said about it.

#include "core/fit/fit_run.h"

#include <atomic>
#include <limits>
#include <mutex>

#include <QtTest>
#include <tbb/global_control.h>

#include "core/fit/tile_order.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/core/fit/picture_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// Counts what it is asked to solve. Its answer for a pixel is made of the pixel's channels.
class CountingSolver final : public PixelSolver {
 public:
  CountingSolver()
      : PixelSolver(std::make_shared<const ResponseModel>(test::li2024(),
                                                          responseRows(test::albedoRig()))) {}

  void solve(PixelRows<const float> channels, PixelRows<float> values,
             const SolveReport& report) const override {
    solved += channels.count;
    for (std::size_t i = 0; i < channels.count; ++i) {
      for (std::size_t k = 0; k < kParameterCount; ++k)
        values.at(k, i) = static_cast<float>(k + 1) * channels.at(k % 3, i);
      const bool hard = channels.at(0, i) > 0.9f;
      report.states[i] = hard ? PixelState::noConvergence : PixelState::solved;
      report.iterations[i] = hard ? 40 : 2;
    }
    if (whenSolving) whenSolving();
  }
  void deviations(PixelRows<const float>, PixelRows<const float> values,
                  PixelRows<float> deviations) const override {
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      for (std::size_t i = 0; i < values.count; ++i)
        deviations.at(k, i) = values.at(k, i) / 8.0f;
    }
  }
  bool hasDeviations() const override { return true; }
  const char* stage() const override { return "counting"; }

  mutable std::atomic<std::size_t> solved = 0;
  std::function<void()> whenSolving;
};

std::vector<float> skin(int x, int y) {
  return {0.4f + 0.0001f * static_cast<float>(x), 0.3f + 0.0001f * static_cast<float>(y), 0.2f};
}

class FitRunTest : public QObject {
  Q_OBJECT

 private slots:
  void eachPixelIsCountedOnce() {
    const auto state = [](int x, int y) {
      if (y < 10) return PixelState::masked;
      if (y < 13) return PixelState::saturated;
      if (y == 13) return PixelState::invalid;
      return x == 0 ? PixelState::noConvergence : PixelState::solved;
    };
    const Measurements picture = test::photograph(
        test::albedoRig(), 300, 290, [](int x, int y) { return skin(x, y); }, state);
    const CountingSolver solver;
    const FitPlanes planes(picture, {}, nullptr);
    const auto statistics = runFit(picture, solver, planes, {});
    EXPECT_OK(statistics);
    const auto& pixels = statistics.value().pixels;
    QCOMPARE(pixels.total, std::uint64_t{300 * 290});
    QCOMPARE(pixels.masked, std::uint64_t{300 * 10});
    QCOMPARE(pixels.saturated, std::uint64_t{300 * 3});
    QCOMPARE(pixels.invalid, std::uint64_t{300});
    QCOMPARE(pixels.solved + pixels.duplicate, std::uint64_t{300 * 276});
    QCOMPARE(pixels.solved, std::uint64_t{solver.solved});
    QCOMPARE(statistics.value().maximumIterations, 2);
    EXPECT_NEAR(statistics.value().meanIterations, 2.0, 0.0);
    // The state of what was not solved stays what it was.
    const std::vector<float> states = test::pixelsOf(planes.maps.state);
    QCOMPARE(states[5], 1.0f);
    QCOMPARE(states[11 * 300], 3.0f);
    QCOMPARE(states[13 * 300], 2.0f);
    QCOMPARE(states[20 * 300], 0.0f);
  }

  void whatIsNotSolvedStaysZero() {
    const auto state = [](int x, int y) {
      return (x + y) % 2 ? PixelState::masked : PixelState::solved;
    };
    const Measurements picture = test::photograph(
        test::albedoRig(), 40, 30, [](int x, int y) { return skin(x, y); }, state);
    FitOptions options;
    options.deviations = options.residuals = true;
    FitPlanes planes(picture, options, nullptr);
    // Something old is there.
    const std::vector<float> old(40 * 30, 9.0f);
    for (Plane& plane : planes.maps.values)
      EXPECT_OK(plane.store(plane.bounds(), old));
    for (Plane& plane : planes.deviations)
      EXPECT_OK(plane.store(plane.bounds(), old));
    for (Plane& plane : planes.residuals)
      EXPECT_OK(plane.store(plane.bounds(), old));
    EXPECT_OK(runFit(picture, CountingSolver(), planes, {}));
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      const std::vector<float> values = test::pixelsOf(planes.maps.values[k]);
      const std::vector<float> deviations = test::pixelsOf(planes.deviations[k]);
      for (int i = 0; i < 40 * 30; ++i) {
        const int x = i % 40, y = i / 40;
        const auto at = static_cast<std::size_t>(i);
        const float expected = (x + y) % 2 ? 0.0f : static_cast<float>(k + 1) * skin(x, y)[k % 3];
        QCOMPARE(values[at], expected);
        QCOMPARE(deviations[at], expected / 8.0f);
      }
    }
    for (const Plane& plane : planes.residuals) {
      const std::vector<float> residuals = test::pixelsOf(plane);
      for (int i = 0; i < 40 * 30; ++i) {
        if ((i % 40 + i / 40) % 2) QCOMPARE(residuals[std::size_t(i)], 0.0f);
      }
    }
  }

  void tilesInViewComeFirst() {
    const Measurements picture =
        test::photograph(test::albedoRig(), 1100, 600, [](int x, int y) { return skin(x, y); });
    const FitPlanes planes(picture, {}, nullptr);
    std::vector<Rect> order;
    FitObserver observer;
    observer.finished = [&](const Rect& rect) { order.push_back(rect); };
    observer.view = [] { return Rect{900, 500, 1000, 580}; };
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_OK(runFit(picture, CountingSolver(), planes, {}, observer));
    QCOMPARE(order.size(), static_cast<std::size_t>(planes.maps.state.tileCount()));
    QVERIFY(order.front().contains(950, 540));
    QVERIFY(order.back().contains(0, 0));
  }

  void everyTileIsHandedOutOnce() {
    const std::vector<Rect> tiles = {{0, 0, 8, 8}, {8, 0, 16, 8}, {16, 0, 24, 8}, {24, 0, 32, 8}};
    TileOrder order(tiles);
    QCOMPARE(order.next({20, 0, 21, 8}), std::size_t{2});
    QCOMPARE(order.next({14, 0, 18, 8}), std::size_t{1});
    QCOMPARE(order.next({}), std::size_t{0});
    QCOMPARE(order.next({0, 0, 1, 1}), std::size_t{3});
  }

  // Whoever made the measurements may have overlooked something.
  void brokenPixelsAreFoundOut() {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Measurements picture = test::photograph(test::albedoRig(), 6, 1, [&](int x, int) {
      const std::vector<std::vector<float>> pixels = {
          {nan, 1, 1}, {-1, 1, 1}, {0, 0, 0}, {1, 1, INFINITY}, {0.3f, 0.2f, 0.1f}, {0, 0.1f, 0}};
      return pixels[static_cast<std::size_t>(x)];
    });
    const CountingSolver solver;
    const FitPlanes planes(picture, {}, nullptr);
    const auto statistics = runFit(picture, solver, planes, {});
    EXPECT_OK(statistics);
    QCOMPARE(statistics.value().pixels.invalid, std::uint64_t{4});
    QCOMPARE(statistics.value().pixels.solved, std::uint64_t{2});
    const std::vector<float> expected = {2, 2, 2, 2, 0, 0};
    QVERIFY(test::pixelsOf(planes.maps.state) == expected);
  }

  // 8-bit textures: few colours, each solved once a tile.
  void equalPixelsAreSolvedOnce() {
    const Measurements picture = test::photograph(
        test::albedoRig(), 256, 256, [](int x, int y) { return skin(x / 16, y / 16); });
    const CountingSolver solver;
    const FitPlanes planes(picture, {}, nullptr);
    const auto statistics = runFit(picture, solver, planes, {});
    EXPECT_OK(statistics);
    QCOMPARE(statistics.value().pixels.solved, std::uint64_t{256});
    QCOMPARE(statistics.value().pixels.duplicate, std::uint64_t{65536 - 256});
    QCOMPARE(solver.solved.load(), std::size_t{256});
    const std::vector<float> melanin = test::pixelsOf(planes.maps.values[0]);
    for (int i = 0; i < 65536; ++i) {
      QCOMPARE(melanin[std::size_t(i)], skin(i % 256 / 16, i / 256 / 16)[0]);
    }
  }

  void hardPixelsAreReported() {
    const Measurements picture = test::photograph(test::albedoRig(), 10, 10, [](int x, int) {
      return std::vector<float>{x < 3 ? 0.95f : 0.5f, 0.3f, 0.2f};
    });
    const FitPlanes planes(picture, {}, nullptr);
    const auto statistics = runFit(picture, CountingSolver(), planes, {});
    EXPECT_OK(statistics);
    QCOMPARE(statistics.value().pixels.noConvergence, std::uint64_t{30});
    QCOMPARE(statistics.value().pixels.solved, std::uint64_t{2});
    QCOMPARE(statistics.value().maximumIterations, 40);
    EXPECT_NEAR(statistics.value().meanIterations, 21.0, 1e-12);
    QCOMPARE(test::pixelsOf(planes.maps.state)[0], 4.0f);
    // They have their estimate all the same.
    QCOMPARE(test::pixelsOf(planes.maps.values[0])[0], 0.95f);
  }

  void everyRectangleIsFinishedOnce() {
    const Measurements picture = test::skinPhotograph(test::albedoRig(), 600, 300);
    std::mutex mutex;
    std::vector<Rect> finished;
    const FitPlanes planes(picture, {}, nullptr);
    FitObserver observer;
    observer.finished = [&](const Rect& rect) {
      const std::scoped_lock lock(mutex);
      finished.push_back(rect);
    };
    EXPECT_OK(runFit(picture, CountingSolver(), planes, {}, observer));
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < finished.size(); ++i) {
      pixels += finished[i].pixelCount();
      for (std::size_t j = 0; j < i; ++j)
        QVERIFY(intersection(finished[i], finished[j]).empty());
    }
    QCOMPARE(pixels, std::size_t{600 * 300});
  }

  void stopsSoonAndLeavesNoResult() {
    const Measurements picture = test::skinPhotograph(test::albedoRig(), 512, 512);
    std::stop_source source;
    JobContext context;
    context.stop = source.get_token();
    CountingSolver solver;
    solver.whenSolving = [&] { source.request_stop(); };
    QVERIFY(runFit(picture, solver, FitPlanes(picture, {}, nullptr), context).cancelled());
    // No more was solved than what was in flight on each thread.
    QVERIFY(solver.solved <= 16 * 256);
  }

  void progressNamesItsStageAndReachesItsEnd() {
    const Measurements picture = test::skinPhotograph(test::albedoRig(), 600, 300);
    std::mutex mutex;
    double highest = 0.0;
    bool named = true;
    JobContext context;
    context.progress = Progress([&](double fraction, const std::string& stage) {
      const std::scoped_lock lock(mutex);
      highest = std::max(highest, fraction);
      named = named && stage == "counting";
    });
    EXPECT_OK(runFit(picture, CountingSolver(), FitPlanes(picture, {}, nullptr), context));
    EXPECT_NEAR(highest, 1.0, 0.0);
    QVERIFY(named);
  }

  void nothingToSolveIsFine() {
    const Measurements picture = test::photograph(
        test::albedoRig(), 5, 5, [](int, int) { return std::vector<float>(3, 0.0f); });
    const auto statistics = runFit(picture, CountingSolver(), FitPlanes(picture, {}, nullptr), {});
    EXPECT_OK(statistics);
    QCOMPARE(statistics.value().pixels.invalid, std::uint64_t{25});
    EXPECT_NEAR(statistics.value().meanResidual, 0.0, 0.0);
    EXPECT_NEAR(statistics.value().meanIterations, 0.0, 0.0);
  }
};

CUTIS_TEST(FitRunTest)

}  // namespace
}  // namespace cutis

#include "fit_run_test.moc"
