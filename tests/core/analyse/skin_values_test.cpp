#include "core/analyse/skin_values.h"

#include <algorithm>

#include <QtTest>

#include "core/skin/pixel_state.h"
#include "core/skin/profile/chromophore_table.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// Over a tile's side, so that there are several.
constexpr int kSkinWidth = 300, kSkinHeight = 2;
constexpr std::size_t kSkinPixels = std::size_t{kSkinWidth} * kSkinHeight;
constexpr Rect kSkinRect = {0, 0, kSkinWidth, kSkinHeight};

// The first `hair` pixels have as much melanin as there can be, the others from 0.02 to 0.08.
ChromophoreMaps mapsWithHair(std::size_t hair) {
  ChromophoreMaps maps(kSkinWidth, kSkinHeight);
  std::vector<float> values(kSkinPixels, 0.01f),
      states(kSkinPixels, static_cast<float>(PixelState::solved));
  for (std::size_t i = 0; i < kSkinPixels; ++i) {
    const float share = static_cast<float>(i - hair) / static_cast<float>(kSkinPixels - hair);
    values[i] = i < hair ? 0.5f : 0.02f + 0.06f * share;
  }
  static_cast<void>(maps.values[kMelanin].store(kSkinRect, values));
  static_cast<void>(maps.state.store(kSkinRect, states));
  return maps;
}

class SkinValuesTest : public QObject {
  Q_OBJECT

 private slots:
  void hairDoesNotCount() {
    const auto values = skinValuesOf(mapsWithHair(kSkinPixels / 2), paperAxes(), {});
    EXPECT_OK(values);
    const auto& melanin = values.value().sorted[kMelanin];
    QCOMPARE(melanin.size(), kSkinPixels / 2);
    QVERIFY(std::is_sorted(melanin.begin(), melanin.end()));
    const auto range = typicalRange(melanin);
    QVERIFY(range.has_value());
    EXPECT_NEAR(range->minimum, 0.0206, 3e-4);
    EXPECT_NEAR(range->maximum, 0.0794, 3e-4);
  }

  void whereAllIsHairAllCounts() {
    const auto values = skinValuesOf(mapsWithHair(kSkinPixels), paperAxes(), {});
    EXPECT_OK(values);
    QCOMPARE(values.value().sorted[kMelanin].size(), kSkinPixels);
    QVERIFY(!typicalRange(values.value().sorted[kMelanin]));
  }

  void whatHasNoEstimateDoesNotCount() {
    ChromophoreMaps maps = mapsWithHair(0);
    const std::vector<float> masked(kSkinPixels, static_cast<float>(PixelState::masked));
    QVERIFY(!maps.state.store(kSkinRect, masked).failed());
    const auto values = skinValuesOf(maps, paperAxes(), {});
    EXPECT_OK(values);
    QVERIFY(values.value().sorted[kMelanin].empty());
    QVERIFY(!typicalRange({}));
  }
};

CUTIS_TEST(SkinValuesTest)

}  // namespace
}  // namespace cutis

#include "skin_values_test.moc"
