#include "core/simulate/skin_patch.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <vector>

#include <QtTest>
#include <tbb/global_control.h>

#include "core/simulate/paint/lips.h"
#include "core/simulate/paint/patch_painter.h"
#include "core/simulate/paint/veins.h"
#include "core/skin/parameter_buffer.h"
#include "core/skin/pixel_state.h"
#include "core/spectra/colorimetry.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kSize = 512;

const ParameterAxes& axes() {
  return test::li2024().profile().axes;
}

// A patch in memory.
struct Patch {
  int width = 0;
  int height = 0;
  ParameterBuffer values;
  std::vector<float> states, mask;

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  float at(Parameter parameter, std::size_t i) const {
    return values.values[static_cast<std::size_t>(parameter)][i];
  }
};

Patch simulate(int width, int height, std::uint64_t seed = 1, const SkinRecipe& recipe = {}) {
  const auto skin = simulateSkin(recipe, width, height, seed, axes(), nullptr, {});
  Patch patch;
  if (!skin) {
    qWarning("%s", skin.failed() ? skin.error().text().c_str() : "cancelled");
    return patch;
  }
  patch.width = width;
  patch.height = height;
  const Rect all = {0, 0, width, height};
  auto values = loadParameters(skin.value().maps, all);
  patch.states.resize(all.pixelCount());
  patch.mask.resize(all.pixelCount());
  const bool loaded = values && skin.value().maps.state.load(all, patch.states) &&
                      skin.value().mask.load(all, patch.mask);
  if (loaded) patch.values = std::move(values).value();
  return patch;
}

const Patch& sample() {
  static const Patch patch = simulate(kSize, kSize);
  return patch;
}

// Median of a parameter over the skin where inside(x, y), in fractions of the patch, holds.
double median(const Patch& patch, Parameter parameter,
              const std::function<bool(double, double)>& inside) {
  std::vector<float> values;
  for (int y = 0; y < patch.height; ++y) {
    for (int x = 0; x < patch.width; ++x) {
      const std::size_t i = patch.index(x, y);
      if (patch.mask[i] > 0.0f && inside((x + 0.5) / patch.width, (y + 0.5) / patch.height)) {
        values.push_back(patch.at(parameter, i));
      }
    }
  }
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::function<bool(double, double)> disc(double x, double y, double radius) {
  return [=](double px, double py) { return std::hypot(px - x, py - y) < radius; };
}

bool same(const Patch& a, const Patch& b) {
  return a.values.values == b.values.values && a.states == b.states && a.mask == b.mask;
}

class SkinPatchTest : public QObject {
  Q_OBJECT

 private slots:
  void sameSeedSameBytes() { QVERIFY(same(sample(), simulate(kSize, kSize))); }

  void threadsDoNotMatter() {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    QVERIFY(same(sample(), simulate(kSize, kSize)));
  }

  void anotherSeedIsAnotherPatch() {
    const Patch other = simulate(kSize, kSize, 2);
    QVERIFY(!same(sample(), other));
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      QVERIFY(!std::ranges::equal(sample().values.values[k], other.values.values[k]));
    }
  }

  // A rectangle of any shape has the bits of the whole.
  void tilesDoNotMatter() {
    const SkinRecipe recipe;
    const PatchPainter painter(recipe, {kSize, kSize}, 1);
    for (const Rect& rect : {Rect{0, 0, 1, 1}, Rect{100, 211, 353, 260}, Rect{17, 400, 19, 512},
                             Rect{220, 290, 400, 410}}) {
      const PatchTile tile = painter.paint(rect);
      const std::vector<float> mask = painter.mask(rect);
      for (int y = rect.y0; y < rect.y1; ++y) {
        for (int x = rect.x0; x < rect.x1; ++x) {
          const std::size_t whole = sample().index(x, y);
          QCOMPARE(mask[tile.index(x, y)], sample().mask[whole]);
          if (sample().mask[whole] == 0.0f) continue;
          for (std::size_t k = 0; k < kParameterCount; ++k) {
            QCOMPARE(tile.values[k][tile.index(x, y)], sample().values.values[k][whole]);
          }
        }
      }
    }
  }

  void everyPixelIsWithinTheAxes_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::newRow("1x1") << 1 << 1;
    QTest::newRow("3x2") << 3 << 2;
    QTest::newRow("64x64") << 64 << 64;
    QTest::newRow("333x777") << 333 << 777;
    QTest::newRow("8192x1") << 8192 << 1;
    QTest::newRow("40x2000") << 40 << 2000;
  }
  void everyPixelIsWithinTheAxes() {
    QFETCH(int, width);
    QFETCH(int, height);
    const Patch patch = simulate(width, height);
    QCOMPARE(patch.values.count(), (Rect{0, 0, width, height}).pixelCount());
    std::size_t skin = 0;
    for (std::size_t i = 0; i < patch.values.count(); ++i) {
      const bool isSkin = patch.mask[i] == 1.0f;
      QVERIFY(isSkin || patch.mask[i] == 0.0f);
      const PixelState state = isSkin ? PixelState::solved : PixelState::masked;
      QCOMPARE(patch.states[i], static_cast<float>(state));
      skin += isSkin ? 1 : 0;
      for (const Parameter parameter : kParameters) {
        const double value = patch.at(parameter, i);
        const double maximum = axes()[static_cast<std::size_t>(parameter)].maximum;
        QVERIFY(value >= 0.0 && value <= static_cast<double>(static_cast<float>(maximum)));
        if (!isSkin) QCOMPARE(value, 0.0);
      }
    }
    QVERIFY(skin > patch.values.count() / 2);
  }

  void narrowAxesAreKept() {
    ParameterAxes narrow = axes();
    narrow[kMelanin].maximum = 0.02;
    const auto skin = simulateSkin({}, 64, 64, 1, narrow, nullptr, {});
    EXPECT_OK(skin);
    const auto values = loadParameters(skin.value().maps, {0, 0, 64, 64});
    EXPECT_OK(values);
    const auto& melanin = values.value().values[kMelanin];
    EXPECT_NEAR(*std::max_element(melanin.begin(), melanin.end()), 0.02, 1e-9);
  }

  void cornersAreBackground() {
    const Patch& patch = sample();
    for (const int x : {0, kSize - 1}) {
      for (const int y : {0, kSize - 1})
        QCOMPARE(patch.mask[patch.index(x, y)], 0.0f);
    }
    double share = 0.0;
    for (const float inside : patch.mask)
      share += inside;
    share /= static_cast<double>(patch.mask.size());
    QVERIFY2(share > 0.75 && share < 0.95, qPrintable(QString::number(share)));
  }

  // Values of a face, with room for moles, hairs and vessels.
  void valuesArePhysiological() {
    const auto everywhere = [](double, double) { return true; };
    EXPECT_NEAR(median(sample(), kMelanin, everywhere), 0.025, 0.010);
    EXPECT_NEAR(median(sample(), kMelaninBlend, everywhere), 0.4, 0.1);
    EXPECT_NEAR(median(sample(), kHaemoglobinDermal, everywhere), 0.02, 0.008);
    EXPECT_NEAR(median(sample(), kHaemoglobinEpidermal, everywhere), 0.03, 0.01);
    EXPECT_NEAR(median(sample(), kCarotene, everywhere), 0.0016, 0.0006);
  }

  // Groups by individual typology angle: light above 41°, intermediate, tan, dark below 10°.
  void allToneGroupsArePresent() {
    const SpectrumRows rows = responseRows(test::albedoRig());
    const Eigen::Vector3d white =
        whitePoint(test::albedoRig().lights[0].power, test::albedoRig().camera.sensor);
    std::array<int, 4> groups = {};
    int count = 0;
    for (std::size_t i = 0; i < sample().values.count(); i += 97) {
      if (sample().mask[i] == 0.0f) continue;
      ParameterVector p;
      for (const Parameter parameter : kParameters)
        p[parameter] = sample().at(parameter, i);
      const Eigen::Vector3d xyz =
          (rows.matrix() * test::li2024().reflectance(p).matrix()).cwiseProduct(white);
      const double angle = individualTypologyAngle(labFromXyz(xyz, white));
      ++groups[angle > 41.0 ? 0 : angle > 28.0 ? 1 : angle > 10.0 ? 2 : 3];
      ++count;
    }
    for (const int group : groups)
      QVERIFY(group > count / 10);
  }

  void flushIsRedderThanItsSurroundings() {
    const SoftArea area = SkinRecipe().flushes[0].area;
    const auto centre = disc(area.x, area.y, 0.12);
    SkinRecipe pale;
    pale.flushes.clear();
    const Patch without = simulate(kSize, kSize, 1, pale);
    for (const Parameter parameter : {kHaemoglobinDermal, kHaemoglobinEpidermal}) {
      const double with = median(sample(), parameter, centre);
      const double bare = median(without, parameter, centre);
      QVERIFY2(with > 1.2 * bare, qPrintable(QString("%1 %2").arg(with).arg(bare)));
    }
  }

  void caroteneAreaIsYellow() {
    const SoftArea area = SkinRecipe().carotene.area;
    QVERIFY(median(sample(), kCarotene, disc(area.x, area.y, 0.06)) >
            2.0 * median(sample(), kCarotene, disc(0.5, 0.5, 0.1)));
  }

  void veinsBranchAndHoldBlood() {
    const SkinRecipe recipe;
    const PatchFrame frame = {kSize, kSize};
    const Veins veins(recipe.veins, frame, 1);
    QVERIFY(veins.segments().size() > 200);
    SkinRecipe bare;
    bare.veins.clear();
    const Patch without = simulate(kSize, kSize, 1, bare);
    // Along the strongest vessels.
    int pixels = 0;
    for (const VeinSegment& s : veins.segments()) {
      if (s.dermal < 0.15f || s.radius < 1.5f) continue;
      const std::size_t i = sample().index(static_cast<int>(s.x1), static_cast<int>(s.y1));
      QVERIFY(sample().at(kHaemoglobinDermal, i) > without.at(kHaemoglobinDermal, i) + 0.06f);
      ++pixels;
    }
    QVERIFY2(pixels > 30, qPrintable(QString::number(pixels)));
  }

  void lipsAreFullOfBlood() {
    const SkinRecipe recipe;
    const Lips lips(recipe.lips, {kSize, kSize}, 1);
    const auto on = [&](double x, double y) {
      return lips.depth(static_cast<float>(x * kSize), static_cast<float>(y * kSize)) > 6.0f;
    };
    const auto around = [&](double x, double y) {
      const float depth = lips.depth(static_cast<float>(x * kSize), static_cast<float>(y * kSize));
      return depth < -8.0f && depth > -30.0f;
    };
    QVERIFY(median(sample(), kHaemoglobinDermal, on) >
            2.0 * median(sample(), kHaemoglobinDermal, around));
    QVERIFY(median(sample(), kHaemoglobinEpidermal, on) >
            1.6 * median(sample(), kHaemoglobinEpidermal, around));
    QVERIFY(median(sample(), kMelanin, on) < 0.8 * median(sample(), kMelanin, around));
  }

  void molesAreDark() {
    const double side = kSize;
    const SkinRecipe recipe;
    for (const MoleRecipe& mole : recipe.moles) {
      const double centre = median(sample(), kMelanin, disc(mole.x, mole.y, 1.5 / side));
      EXPECT_NEAR(centre, mole.melanin, 0.3 * mole.melanin);
      QVERIFY(centre > 1.5 * median(sample(), kMelanin, disc(mole.x, mole.y, 4.0 * mole.radius)));
    }
  }

  void frecklesLieWhereTheyShould() {
    SkinRecipe clear;
    clear.freckles.chance = 0.0;
    clear.freckles.scatter = 0.0;
    const Patch without = simulate(kSize, kSize, 1, clear);
    const SoftArea area = SkinRecipe().freckles.areas[0];
    const auto freckled = [&](double x, double y, double radius) {
      int spotted = 0, all = 0;
      for (int py = 0; py < kSize; ++py) {
        for (int px = 0; px < kSize; ++px) {
          if (!disc(x, y, radius)((px + 0.5) / kSize, (py + 0.5) / kSize)) continue;
          const std::size_t i = sample().index(px, py);
          spotted += sample().at(kMelanin, i) > 1.15f * without.at(kMelanin, i) ? 1 : 0;
          ++all;
        }
      }
      return static_cast<double>(spotted) / all;
    };
    const double spotted = freckled(area.x, area.y, 0.1);
    QVERIFY2(spotted > 0.03 && spotted < 0.4, qPrintable(QString::number(spotted)));
    EXPECT_AT_MOST(freckled(0.3, 0.75, 0.1), 0.02);
  }

  void stubbleIsShortDarkHair() {
    int dark = 0, all = 0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        if (!disc(0.45, 0.87, 0.08)((x + 0.5) / kSize, (y + 0.5) / kSize)) continue;
        const std::size_t i = sample().index(x, y);
        const bool isHair = sample().at(kMelanin, i) > 0.2f;
        if (isHair) QVERIFY(sample().at(kMelaninBlend, i) > 0.6f);
        dark += isHair ? 1 : 0;
        ++all;
      }
    }
    const double share = static_cast<double>(dark) / all;
    QVERIFY2(share > 0.01 && share < 0.2, qPrintable(QString::number(share)));
  }

  void poresAndNoiseVaryEveryParameter() {
    const auto cheek = disc(0.3, 0.3, 0.05);
    SkinRecipe poreless;
    poreless.pores.melanin = poreless.pores.dermal = poreless.pores.epidermal = 0.0;
    const Patch without = simulate(kSize, kSize, 1, poreless);
    int deeper = 0, all = 0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        if (!cheek((x + 0.5) / kSize, (y + 0.5) / kSize)) continue;
        const std::size_t i = sample().index(x, y);
        deeper += sample().at(kHaemoglobinDermal, i) > 1.1f * without.at(kHaemoglobinDermal, i);
        ++all;
      }
    }
    QVERIFY(deeper > all / 50 && deeper < all / 3);
    for (const Parameter parameter : kParameters) {
      std::vector<float> row;
      for (int x = 150; x < 200; ++x)
        row.push_back(sample().at(parameter, sample().index(x, 150)));
      std::sort(row.begin(), row.end());
      QVERIFY(std::adjacent_find(row.begin(), row.end()) == row.end());
    }
  }

  void impossibleSizesAreRefused() {
    EXPECT_ERROR(simulateSkin({}, 0, 5, 1, axes(), nullptr, {}), "0 × 5 pixels; choose 1 to 8192");
    EXPECT_ERROR(simulateSkin({}, 8193, 5, 1, axes(), nullptr, {}), "8193 × 5");
  }

  void stopsWhenAsked() {
    std::stop_source source;
    source.request_stop();
    JobContext context;
    context.stop = source.get_token();
    QVERIFY(simulateSkin({}, 2000, 2000, 1, axes(), nullptr, context).cancelled());
  }

  void reportsItsProgress() {
    std::atomic<double> last = 0.0;
    JobContext context;
    context.progress = Progress([&](double fraction, const std::string&) {
      if (fraction > last) last = fraction;
    });
    EXPECT_OK(simulateSkin({}, 600, 600, 1, axes(), nullptr, context));
    EXPECT_NEAR(last, 1.0, 1e-12);
  }
};

CUTIS_TEST(SkinPatchTest)

}  // namespace
}  // namespace cutis

#include "skin_patch_test.moc"
