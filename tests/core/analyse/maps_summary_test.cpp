#include "core/analyse/maps_summary.h"

#include <QtTest>

#include "core/skin/pixel_state.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// Over a tile's side, so that there are several.
constexpr int kWidth = 300, kHeight = 3;
constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;

Plane planeOf(const std::vector<float>& values) {
  Plane plane(kWidth, kHeight, PixelFormat::float32);
  static_cast<void>(plane.store({0, 0, kWidth, kHeight}, values));
  return plane;
}

class MapsSummaryTest : public QObject {
  Q_OBJECT

 private slots:
  void pixelsAreCountedByState() {
    std::vector<float> states(kPixels, static_cast<float>(PixelState::solved));
    states[0] = static_cast<float>(PixelState::masked);
    states[299] = static_cast<float>(PixelState::saturated);
    states[899] = static_cast<float>(PixelState::noConvergence);
    states[500] = 77.0f;
    const auto counts = countStates(planeOf(states));
    EXPECT_OK(counts);
    QVERIFY((counts.value() == StateCounts{kPixels - 4, 1, 0, 1, 1}));
  }

  void valuesSpreadOverEstimates() {
    std::vector<float> states(kPixels, static_cast<float>(PixelState::invalid)),
        values(kPixels, 9e9f);
    // 0, 1 … 100 in a random-looking order, in pixels with an estimate.
    for (std::size_t i = 0; i <= 100; ++i) {
      const std::size_t pixel = i * 8;
      states[pixel] =
          static_cast<float>(i % 2 == 0 ? PixelState::solved : PixelState::noConvergence);
      values[pixel] = static_cast<float>(i * 37 % 101);
    }
    const auto spread = spreadOf(planeOf(values), planeOf(states));
    EXPECT_OK(spread);
    QVERIFY(spread.value().has_value());
    QCOMPARE(spread.value()->low, 5.0f);
    QCOMPARE(spread.value()->median, 50.0f);
    QCOMPARE(spread.value()->high, 95.0f);
  }

  void withoutEstimatesThereIsNoSpread() {
    const std::vector<float> masked(kPixels, static_cast<float>(PixelState::masked));
    const auto spread = spreadOf(planeOf(masked), planeOf(masked));
    EXPECT_OK(spread);
    QVERIFY(!spread.value());
  }
};

CUTIS_TEST(MapsSummaryTest)

}  // namespace
}  // namespace cutis

#include "maps_summary_test.moc"
