// Many threads on one plane, with a budget so small that tiles come and go all the time.

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include <QtTest>

#include "core/base/parallel.h"
#include "core/base/plane.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kSide = 1000;  // 16 tiles
constexpr std::size_t kTileBytes = 256 * 256 * 4;

// All pixels of a tile have one value, or the answer is −1.
float valueOf(const Plane& plane, const Rect& tile) {
  std::vector<float> values(tile.pixelCount());
  if (!plane.load(tile, values)) return -1.0f;
  const bool uniform = std::all_of(values.begin(), values.end(),
                                   [&](float value) { return value == values.front(); });
  return uniform ? values.front() : -1.0f;
}

class PlaneConcurrencyTest : public QObject {
  Q_OBJECT

 private slots:
  void readersSeeATileAsItWasOrAsItIs_data() {
    QTest::addColumn<qulonglong>("budget");
    QTest::newRow("unlimited") << qulonglong{TileStore::kUnlimited};
    QTest::newRow("three tiles") << qulonglong{3 * kTileBytes};
  }
  void readersSeeATileAsItWasOrAsItIs() {
    QFETCH(qulonglong, budget);
    const auto store = std::make_shared<TileStore>(budget);
    Plane plane(kSide, kSide, PixelFormat::float32, store);
    constexpr int kWriters = 4;
    constexpr int kRounds = 12;
    std::atomic<int> working = kWriters;
    std::atomic<int> torn = 0, backwards = 0, failed = 0;
    std::vector<std::jthread> threads;
    for (int writer = 0; writer < kWriters; ++writer) {
      threads.emplace_back([&, writer] {
        for (int round = 1; round <= kRounds; ++round) {
          for (int tile = writer; tile < plane.tileCount(); tile += kWriters) {
            const Rect rect = plane.tileRect(tile);
            const std::vector<float> values(rect.pixelCount(), static_cast<float>(round));
            if (!plane.store(rect, values)) ++failed;
          }
        }
        --working;
      });
    }
    for (int reader = 0; reader < 3; ++reader) {
      threads.emplace_back([&, reader] {
        std::vector<float> seen(static_cast<std::size_t>(plane.tileCount()), 0.0f);
        for (int i = reader; working > 0; i += 5) {
          const int tile = i % plane.tileCount();
          const float value = valueOf(plane, plane.tileRect(tile));
          if (value < 0.0f) ++torn;
          auto& last = seen[static_cast<std::size_t>(tile)];
          if (value < last) ++backwards;
          last = value;
        }
      });
    }
    threads.clear();  // joins
    QCOMPARE(failed.load(), 0);
    QCOMPARE(torn.load(), 0);
    QCOMPARE(backwards.load(), 0);
    for (int i = 0; i < plane.tileCount(); ++i) {
      QCOMPARE(valueOf(plane, plane.tileRect(i)), static_cast<float>(kRounds));
    }
    // Old tiles are gone: exactly one per place is left.
    const auto statistics = store->statistics();
    QVERIFY(statistics.bytesInMemory <= std::max<qulonglong>(budget, kTileBytes) ||
            budget == TileStore::kUnlimited);
    QVERIFY(statistics.bytesInMemory <= std::size_t{kSide} * kSide * 4);
    QVERIFY(statistics.bytesOnDisk <= std::size_t{kSide} * kSide * 4);
  }

  void loadsAcrossTilesWhileOthersStore() {
    const auto store = std::make_shared<TileStore>(2 * kTileBytes);
    Plane plane(kSide, kSide, PixelFormat::half, store);
    const auto count = static_cast<std::size_t>(plane.tileCount());
    EXPECT_OK(parallelFor(4 * count, {}, [&](std::size_t i) -> Status {
      const Rect tile = plane.tileRect(static_cast<int>(i % count));
      if (i < count) {
        const std::vector<float> values(tile.pixelCount(), static_cast<float>(1 + i % count));
        return plane.store(tile, values);
      }
      std::vector<float> all(plane.bounds().pixelCount());
      CUTIS_CHECK(plane.load(plane.bounds(), all));
      for (const float value : all) {
        if (!(value >= 0.0f && value <= static_cast<float>(count))) {
          return inputError("", "a value that nobody stored");
        }
      }
      return {};
    }));
    for (std::size_t i = 0; i < count; ++i) {
      QCOMPARE(valueOf(plane, plane.tileRect(static_cast<int>(i))), static_cast<float>(i + 1));
    }
  }
};

CUTIS_TEST(PlaneConcurrencyTest)

}  // namespace
}  // namespace cutis

#include "plane_concurrency_test.moc"
