#include "core/base/plane.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <QtTest>

#include "core/base/half.h"
#include "core/base/random.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// Sizes at, below and beyond whole tiles.
struct Size {
  int width, height;
};
const std::vector<Size> kSizes = {{1, 1}, {256, 256}, {257, 255}, {700, 513}, {3, 900}};

Rect randomRect(Random& random, int width, int height) {
  const auto within = [&](int limit) { return static_cast<int>(random.uniform() * limit); };
  const int x0 = within(width);
  const int y0 = within(height);
  return {x0, y0, x0 + 1 + within(width - x0), y0 + 1 + within(height - y0)};
}

// What a plane must read as, kept the simple way.
struct Reference {
  Reference(int w, int h) : width(w), values(static_cast<std::size_t>(w) * std::size_t(h)) {}
  float& at(int x, int y) {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  std::vector<float> part(const Rect& rect) {
    std::vector<float> out;
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x)
        out.push_back(at(x, y));
    }
    return out;
  }
  int width;
  std::vector<float> values;
};

std::vector<float> loaded(const Plane& plane, const Rect& rect) {
  std::vector<float> values(rect.pixelCount(), -1.0f);
  if (!plane.load(rect, values)) values.clear();
  return values;
}

class PlaneTest : public QObject {
  Q_OBJECT

 private slots:
  void tilesCoverEveryPixelOnce() {
    for (const auto& [width, height] : kSizes) {
      const Plane plane(width, height);
      std::size_t pixels = 0;
      for (int i = 0; i < plane.tileCount(); ++i) {
        const Rect tile = plane.tileRect(i);
        QVERIFY(!tile.empty() && intersection(tile, plane.bounds()) == tile);
        QVERIFY(tile.width() <= Plane::kTileSize && tile.height() <= Plane::kTileSize);
        pixels += tile.pixelCount();
        for (int j = 0; j < i; ++j)
          QVERIFY(intersection(tile, plane.tileRect(j)).empty());
      }
      QCOMPARE(pixels, plane.bounds().pixelCount());
    }
  }

  void anyRectangleReadsWhatWasStored_data() {
    QTest::addColumn<bool>("half");
    QTest::addColumn<bool>("spilled");
    QTest::newRow("float") << false << false;
    QTest::newRow("half") << true << false;
    QTest::newRow("float, spilled") << false << true;
    QTest::newRow("half, spilled") << true << true;
  }
  void anyRectangleReadsWhatWasStored() {
    QFETCH(bool, half);
    QFETCH(bool, spilled);
    for (const auto& [width, height] : kSizes) {
      const auto store = std::make_shared<TileStore>(spilled ? 100000 : TileStore::kUnlimited);
      Plane plane(width, height, half ? PixelFormat::half : PixelFormat::float32, store);
      Reference reference(width, height);
      Random random(17);
      for (int turn = 0; turn < 60; ++turn) {
        const Rect rect = randomRect(random, width, height);
        std::vector<float> values(rect.pixelCount());
        // Integers below 2048 are exact in half.
        for (float& value : values)
          value = std::floor(static_cast<float>(random.uniform(-2048, 2048)));
        EXPECT_OK(plane.store(rect, values));
        std::size_t i = 0;
        for (int y = rect.y0; y < rect.y1; ++y) {
          for (int x = rect.x0; x < rect.x1; ++x)
            reference.at(x, y) = values[i++];
        }
        const Rect other = randomRect(random, width, height);
        QVERIFY(loaded(plane, other) == reference.part(other));
      }
      QVERIFY(loaded(plane, plane.bounds()) == reference.values);
      QVERIFY(store->statistics().bytesInMemory <= (spilled ? std::size_t{362144} : SIZE_MAX));
    }
  }

  void halfRoundsAsConversionDoes() {
    Plane plane(300, 2, PixelFormat::half);
    std::vector<float> values(600);
    Random random(3);
    for (float& value : values)
      value = static_cast<float>(random.uniform(-1.0, 1.0));
    values[5] = 1e6f;
    EXPECT_OK(plane.store(plane.bounds(), values));
    const std::vector<float> read = loaded(plane, plane.bounds());
    std::vector<std::uint16_t> halves(values.size());
    std::vector<float> expected(values.size());
    convertFloatToHalf(values, halves);
    convertHalfToFloat(halves, expected);
    QVERIFY(read == expected);
    QVERIFY(std::isinf(read[5]));
  }

  void floatsKeepEveryBit() {
    Plane plane(4, 1);
    const std::vector<float> values = {-0.0f, std::nanf("7"), 1e-42f, 3.4e38f};
    EXPECT_OK(plane.store(plane.bounds(), values));
    const std::vector<float> read = loaded(plane, plane.bounds());
    QCOMPARE(std::memcmp(read.data(), values.data(), 16), 0);
  }

  void untouchedTilesAreZeroAndFree() {
    const auto store = std::make_shared<TileStore>();
    Plane plane(10000, 10000, PixelFormat::float32, store);
    QCOMPARE(store->statistics().bytesInMemory, std::size_t{0});
    for (const float value : loaded(plane, {9990, 9990, 10000, 10000}))
      QCOMPARE(value, 0.0f);
    QCOMPARE(store->statistics().bytesInMemory, std::size_t{0});
    EXPECT_OK(plane.store({300, 300, 301, 301}, std::vector<float>{5.0f}));
    QCOMPARE(store->statistics().bytesInMemory, std::size_t{256 * 256 * 4});
    const std::vector<float> around = loaded(plane, {299, 299, 302, 302});
    QCOMPARE(std::accumulate(around.begin(), around.end(), 0.0f), 5.0f);
    QCOMPARE(around[4], 5.0f);
  }

  void copiesShareTheirPixels() {
    Plane plane(10, 10);
    const Plane copy = plane;
    EXPECT_OK(plane.store({2, 3, 3, 4}, std::vector<float>{8.0f}));
    QCOMPARE(loaded(copy, {2, 3, 3, 4}).front(), 8.0f);
  }

  void theLastHandleFreesTheTiles() {
    const auto store = std::make_shared<TileStore>(300000);
    {
      Plane plane(600, 600, PixelFormat::float32, store);
      EXPECT_OK(plane.store(plane.bounds(), std::vector<float>(360000, 1.0f)));
      EXPECT_OK(plane.store(plane.bounds(), std::vector<float>(360000, 2.0f)));
      const Plane copy = plane;
      QVERIFY(store->statistics().bytesInMemory + store->statistics().bytesOnDisk >= 360000 * 4);
    }
    QCOMPARE(store->statistics().bytesInMemory, std::size_t{0});
    QCOMPARE(store->statistics().bytesOnDisk, std::size_t{0});
  }

  void emptyPlanesAndRectangles() {
    const Plane nothing;
    QVERIFY(nothing.empty());
    QCOMPARE(nothing.width(), 0);
    QCOMPARE(nothing.tileCount(), 0);
    Plane plane(5, 5);
    EXPECT_OK(plane.load({3, 3, 3, 5}, {}));
    EXPECT_OK(plane.store({3, 3, 3, 5}, {}));
  }

  // A spill that fails comes back as an error, and the picture is as it was.
  void aFullDiskIsAnError() {
    const QByteArray saved = qgetenv("TMPDIR");
    qputenv("TMPDIR", "/nowhere");
    const auto store = std::make_shared<TileStore>(1);
    Plane plane(512, 256, PixelFormat::float32, store);
    EXPECT_OK(plane.store({0, 0, 1, 1}, std::vector<float>{1.0f}));
    const Status failed = plane.store({256, 0, 257, 1}, std::vector<float>{2.0f});
    saved.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", saved);
    EXPECT_ERROR(failed, "TMPDIR");
    QVERIFY(loaded(plane, {0, 0, 1, 1}) == std::vector<float>{1.0f});
    QVERIFY(loaded(plane, {256, 0, 257, 1}) == std::vector<float>{0.0f});
  }
};

CUTIS_TEST(PlaneTest)

}  // namespace
}  // namespace cutis

#include "plane_test.moc"
