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

SkinValues valuesOf(const ChromophoreMaps& maps) {
  return skinValuesOf(judgePixels(maps, {}).value(), paperAxes());
}

class SkinValuesTest : public QObject {
  Q_OBJECT

 private slots:
  void hairDoesNotCount() {
    const SkinValues values = valuesOf(mapsWithHair(kSkinPixels / 2));
    const auto& melanin = values.sorted[kMelanin];
    QCOMPARE(melanin.size(), kSkinPixels / 2);
    QVERIFY(std::is_sorted(melanin.begin(), melanin.end()));
    const auto range = typicalRange(melanin);
    QVERIFY(range.has_value());
    EXPECT_NEAR(range->minimum, 0.0206, 3e-4);
    EXPECT_NEAR(range->maximum, 0.0794, 3e-4);
  }

  void whereAllIsHairAllCounts() {
    const SkinValues values = valuesOf(mapsWithHair(kSkinPixels));
    QCOMPARE(values.sorted[kMelanin].size(), kSkinPixels);
    // A parameter that is the same everywhere, as one that was held.
    const auto range = typicalRange(values.sorted[kMelanin]);
    QVERIFY(range.has_value());
    QCOMPARE(range->minimum, 0.0);
    QCOMPARE(range->maximum, 0.5);
  }

  void whatHasNoEstimateDoesNotCount() {
    ChromophoreMaps maps = mapsWithHair(0);
    const std::vector<float> masked(kSkinPixels, static_cast<float>(PixelState::masked));
    QVERIFY(!maps.state.store(kSkinRect, masked).failed());
    QVERIFY(valuesOf(maps).sorted[kMelanin].empty());
    QVERIFY(!typicalRange({}));
  }
};

CUTIS_TEST(SkinValuesTest)

}  // namespace
}  // namespace cutis

#include "skin_values_test.moc"
