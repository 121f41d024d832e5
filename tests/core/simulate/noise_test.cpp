#include <algorithm>
#include <cmath>
#include <vector>

#include <QtTest>

#include "core/simulate/counter_normal.h"
#include "core/simulate/paint/gradient_noise.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
  double kurtosis = 0.0;  // 3 for a normal distribution
  double largest = 0.0;
};

Moments momentsOf(const std::vector<float>& values) {
  Moments m;
  for (const float v : values)
    m.mean += v;
  m.mean /= static_cast<double>(values.size());
  double second = 0.0, fourth = 0.0;
  for (const float v : values) {
    const double squared = (v - m.mean) * (v - m.mean);
    second += squared;
    fourth += squared * squared;
    m.largest = std::max(m.largest, std::abs(static_cast<double>(v)));
  }
  second /= static_cast<double>(values.size());
  fourth /= static_cast<double>(values.size());
  m.deviation = std::sqrt(second);
  m.kurtosis = fourth / (second * second);
  return m;
}

// Share of a standard normal distribution below x.
double normalShareBelow(double x) {
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

std::vector<float> draws(std::uint64_t key, std::size_t count) {
  std::vector<float> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(normalAt(key, i));
  return values;
}

class NoiseTest : public QObject {
  Q_OBJECT

 private slots:
  void normalDrawsAreNormal() {
    constexpr std::size_t kCount = 1'000'000;
    std::vector<float> values = draws(7, kCount);
    const Moments m = momentsOf(values);
    EXPECT_NEAR(m.mean, 0.0, 4e-3);
    EXPECT_NEAR(m.deviation, 1.0, 4e-3);
    EXPECT_NEAR(m.kurtosis, 3.0, 0.03);
    // Kolmogorov & Smirnov: 1.95/√n is passed with probability 0.999.
    std::sort(values.begin(), values.end());
    double largest = 0.0;
    for (std::size_t i = 0; i < kCount; ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(kCount);
      largest = std::max(largest, std::abs(share - normalShareBelow(values[i])));
    }
    EXPECT_AT_MOST(largest, 1.95 / std::sqrt(static_cast<double>(kCount)));
  }

  // The tail is drawn by other code than the rest.
  void tailsHoldTheirShare() {
    constexpr std::size_t kCount = 4'000'000;
    const std::vector<float> values = draws(11, kCount);
    for (const double limit : {2.0, 3.0, 3.5, 4.0}) {
      const auto beyond = static_cast<double>(std::count_if(
          values.begin(), values.end(), [&](float v) { return std::abs(v) > limit; }));
      const double expected = 2.0 * normalShareBelow(-limit) * static_cast<double>(kCount);
      EXPECT_NEAR(beyond, expected, 4.5 * std::sqrt(expected));
    }
  }

  void drawsOfOtherKeysAndNeighboursAreUnrelated() {
    constexpr std::size_t kCount = 200'000;
    const std::vector<float> one = draws(1, kCount + 1);
    const std::vector<float> other = draws(noiseKey(1, 2), kCount);
    double between = 0.0, along = 0.0;
    for (std::size_t i = 0; i < kCount; ++i) {
      between += double{one[i]} * double{other[i]};
      along += double{one[i]} * double{one[i + 1]};
    }
    EXPECT_NEAR(between / kCount, 0.0, 5.0 / std::sqrt(static_cast<double>(kCount)));
    EXPECT_NEAR(along / kCount, 0.0, 5.0 / std::sqrt(static_cast<double>(kCount)));
    QCOMPARE(normalAt(1, 17), one[17]);
  }

  void gradientNoiseHasUnitDeviation() {
    std::vector<float> values;
    Random random(3);
    for (int i = 0; i < 300'000; ++i) {
      values.push_back(gradientNoise(5, static_cast<float>(random.uniform(-400.0, 400.0)),
                                     static_cast<float>(random.uniform(-400.0, 400.0))));
    }
    const Moments m = momentsOf(values);
    EXPECT_NEAR(m.mean, 0.0, 0.02);
    EXPECT_NEAR(m.deviation, 1.0, 0.02);
    EXPECT_AT_MOST(m.largest, 3.3);
  }

  void rowsAreThePointsOfTheNoise() {
    const Rect rect = {250, 99, 301, 140};
    const float cell = 7.3f;
    NoiseRows rows(77, cell, 0.4f, 0.8f, rect);
    // Downwards, and then again from a row far above.
    for (const int y : {99, 100, 101, 107, 108, 139, 100}) {
      std::vector<float> row(static_cast<std::size_t>(rect.width()), 1.0f);
      rows.add(y, 2.0f, row.data());
      for (int x = rect.x0; x < rect.x1; ++x) {
        const float point = gradientNoise(77, (static_cast<float>(x) + 0.5f) / cell + 0.4f,
                                          (static_cast<float>(y) + 0.5f) / cell + 0.8f);
        EXPECT_NEAR(row[static_cast<std::size_t>(x - rect.x0)], 1.0f + 2.0f * point, 2e-5);
      }
    }
  }

  void octavesAddUpToTheDeviation() {
    const PatchFrame frame = {1024, 1024};
    const Rect rect = {0, 0, 1024, 1024};
    FractalRows rows({0.3, 0.05, 4, 0.8}, 9, frame, rect);
    std::vector<float> values;
    std::vector<float> row(1024);
    for (int y = 0; y < 1024; y += 2) {
      rows.row(y, row.data());
      values.insert(values.end(), row.begin(), row.end());
    }
    EXPECT_NEAR(momentsOf(values).deviation, 0.3, 0.03);
  }

  // In a picture of few pixels fine noise would be noise per pixel.
  void octavesFinerThanPixelsAreLeftOut() {
    FractalRows rows({0.3, 0.01, 4, 0.8}, 9, {100, 100}, {0, 0, 100, 100});
    std::vector<float> row(100, 1.0f);
    rows.row(50, row.data());
    QVERIFY(std::all_of(row.begin(), row.end(), [](float v) { return v == 0.0f; }));
  }
};

CUTIS_TEST(NoiseTest)

}  // namespace
}  // namespace cutis

#include "noise_test.moc"
