// What resources/manual/fitting.md promises: duplicates, crops, tiles, tile order and thread counts
// agree bit for bit.

#include <cmath>
#include <cstring>

#include <QtTest>
#include <tbb/global_control.h>

#include "core/base/random.h"
#include "core/fit/fit_run.h"
#include "core/fit/pixel_grouping.h"
#include "core/fit/refined/refined_solver.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/core/fit/picture_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

FitOptions allOutputs() {
  FitOptions options;
  options.deviations = options.residuals = true;
  return options;
}

const PixelSolver& solver() {
  static const auto made = makeRefinedSolver(test::sharedModel(), test::monitorRig(), allOutputs());
  return *made;
}

FitPlanes fitted(const Measurements& picture) {
  FitPlanes planes(picture, allOutputs(), nullptr);
  static_cast<void>(runFit(picture, solver(), planes, {}));
  return planes;
}

bool sameBytes(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), 4 * a.size()) == 0;
}

// Skin with a mask, clipped pixels and areas of one colour.
Measurements mixedPhotograph(int width, int height) {
  const Measurements skin = test::skinPhotograph(test::monitorRig(), width, height);
  std::vector<std::vector<float>> rows;
  for (const Plane& channel : skin.channels)
    rows.push_back(test::pixelsOf(channel));
  const auto at = [&](int x, int y) {
    std::vector<float> pixel;
    for (const auto& row : rows)
      pixel.push_back(row[std::size_t(y) * std::size_t(width) + std::size_t(x)]);
    return pixel;
  };
  return test::photograph(
      test::monitorRig(), width, height,
      [&](int x, int y) { return x % 90 < 40 ? at(x / 10 * 10, y / 10 * 10) : at(x, y); },
      [](int x, int y) {
        if ((x - 200) * (x - 200) + (y - 150) * (y - 150) < 900) return PixelState::masked;
        return x % 50 == 7 ? PixelState::saturated : PixelState::solved;
      });
}

class FitRunDeterminismTest : public QObject {
  Q_OBJECT

 private slots:
  void cropsAgree() {
    const Measurements picture = mixedPhotograph(400, 330);
    const FitPlanes whole = fitted(picture);
    for (const Rect& part : {Rect{0, 0, 100, 100}, Rect{37, 51, 331, 329}, Rect{250, 250, 263, 259},
                             Rect{399, 0, 400, 330}}) {
      const FitPlanes alone = fitted(test::crop(picture, part));
      QVERIFY(sameBytes(test::everything(alone, {0, 0, part.width(), part.height()}),
                        test::everything(whole, part)));
    }
  }

  void threadCountsAgree() {
    const Measurements picture = mixedPhotograph(600, 300);
    std::vector<float> first;
    FitStatistics statistics;
    for (const std::size_t threads : {1, 2, 7}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      FitPlanes planes(picture, allOutputs(), nullptr);
      const auto run = runFit(picture, solver(), planes, {});
      EXPECT_OK(run);
      const std::vector<float> all = test::everything(planes, picture.state.bounds());
      if (first.empty()) {
        first = all;
        statistics = run.value();
      }
      QVERIFY(sameBytes(all, first));
      QCOMPARE(run.value().meanIterations, statistics.meanIterations);
      QCOMPARE(run.value().meanResidual, statistics.meanResidual);
      QCOMPARE(run.value().residual95, statistics.residual95);
      QCOMPARE(run.value().pixels.solved, statistics.pixels.solved);
    }
  }

  void budgetsAgree() {
    const Measurements picture = mixedPhotograph(600, 300);
    FitPlanes spilled(picture, allOutputs(), std::make_shared<TileStore>(300000));
    EXPECT_OK(runFit(picture, solver(), spilled, {}));
    QVERIFY(sameBytes(test::everything(spilled, picture.state.bounds()),
                      test::everything(fitted(picture), picture.state.bounds())));
  }

  // Each pixel alone, in a picture of its own, gives what it gives among its duplicates.
  void duplicatesAgreeWithSinglePixels() {
    const Measurements picture = mixedPhotograph(300, 80);
    const FitPlanes whole = fitted(picture);
    for (int i = 0; i < 120; ++i) {
      const int x = i * 37 % 300, y = i * 11 % 80;
      const Rect pixel = {x, y, x + 1, y + 1};
      QVERIFY(sameBytes(test::everything(fitted(test::crop(picture, pixel)), {0, 0, 1, 1}),
                        test::everything(whole, pixel)));
    }
  }

  void halfMapsAreRoundedFloatMaps() {
    const Measurements picture = mixedPhotograph(300, 40);
    FitOptions half;
    half.mapFormat = PixelFormat::half;
    const FitPlanes planes(picture, half, nullptr);
    EXPECT_OK(runFit(picture, solver(), planes, {}));
    const FitPlanes exact = fitted(picture);
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      const auto rounded = test::pixelsOf(planes.maps.values[k]);
      const auto full = test::pixelsOf(exact.maps.values[k]);
      for (std::size_t i = 0; i < full.size(); ++i) {
        EXPECT_NEAR(rounded[i], full[i], std::abs(full[i]) * 0x1p-11 + 0x1p-25);
      }
    }
    QVERIFY(test::pixelsOf(planes.maps.state) == test::pixelsOf(exact.maps.state));
  }

  // The statistics' residual is of the pixels on every eighth row and column.
  void residualStatisticsAreThePlanes() {
    const Measurements picture = test::skinPhotograph(test::monitorRig(), 300, 300);
    FitPlanes planes(picture, allOutputs(), nullptr);
    const auto run = runFit(picture, solver(), planes, {});
    EXPECT_OK(run);
    std::vector<std::vector<float>> residuals;
    for (const Plane& plane : planes.residuals)
      residuals.push_back(test::pixelsOf(plane));
    std::vector<double> sampled;
    for (int y = 0; y < 300; y += 8) {
      for (int x = 0; x < 300; x += 8) {
        double sum = 0.0;
        for (const auto& row : residuals) {
          const double r = double{row[std::size_t(y * 300 + x)]};
          sum += r * r;
        }
        sampled.push_back(std::sqrt(sum / 9.0));
      }
    }
    std::sort(sampled.begin(), sampled.end());
    double mean = 0.0;
    for (const double r : sampled)
      mean += r / double(sampled.size());
    EXPECT_NEAR(run.value().meanResidual, mean, 1e-6 * mean);
    QVERIFY(run.value().residual95 >= sampled[sampled.size() * 94 / 100]);
    QVERIFY(run.value().residual95 <= sampled[sampled.size() * 96 / 100]);
  }
};

class PixelGroupingTest : public QObject {
  Q_OBJECT

 private slots:
  void equalMeansTheSameBits() {
    const std::vector<float> channels = {1, 2, 1, -0.0f, 0, 1,   // first channel
                                         5, 5, 5, 5,     5, 6};  // second
    const PixelGrouping grouping =
        groupEqualPixels(packedRows(channels.data(), 2, 6), {0, 1, 2, 3, 4, 5});
    QVERIFY((grouping.representatives == std::vector<std::uint32_t>{0, 1, 3, 4, 5}));
    QVERIFY((grouping.groupOf == std::vector<std::uint32_t>{0, 1, 0, 2, 3, 4}));
  }

  // Whether or not looking was worth it, each pixel's representative is its equal.
  void representativesAreEquals() {
    for (const int colours : {1, 7, 300, 1000000}) {
      std::vector<float> channels;
      constexpr std::size_t kCount = 5000;
      Random random(4);
      for (std::size_t i = 0; i < 2 * kCount; ++i) {
        channels.push_back(std::floor(static_cast<float>(random.uniform(0, colours))));
      }
      std::vector<std::uint32_t> pixels;
      for (std::uint32_t i = 0; i < kCount; i += 1 + i % 2)
        pixels.push_back(i);
      const PixelGrouping grouping =
          groupEqualPixels(packedRows(channels.data(), 2, kCount), pixels);
      QCOMPARE(grouping.groupOf.size(), pixels.size());
      QVERIFY(std::is_sorted(grouping.representatives.begin(), grouping.representatives.end()));
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::uint32_t same = grouping.representatives[grouping.groupOf[i]];
        QCOMPARE(channels[same], channels[pixels[i]]);
        QCOMPARE(channels[kCount + same], channels[kCount + pixels[i]]);
      }
    }
  }

  void nothingGivesNothing() {
    const PixelGrouping grouping = groupEqualPixels({}, {});
    QVERIFY(grouping.representatives.empty() && grouping.groupOf.empty());
  }
};

CUTIS_TEST(FitRunDeterminismTest)
CUTIS_TEST(PixelGroupingTest)

}  // namespace
}  // namespace cutis

#include "fit_run_determinism_test.moc"
