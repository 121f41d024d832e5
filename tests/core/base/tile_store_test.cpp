#include "core/base/tile_store.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <QTemporaryDir>
#include <QtTest>

#include "core/base/random.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr std::size_t kTile = 4096;

// Bytes that no other tile has.
TileBytes tileNumber(std::uint64_t number, std::size_t size = kTile) {
  TileBytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<std::byte>(mixBits(number * 1000003 + i) & 0xff);
  }
  return bytes;
}

class TileStoreTest : public QObject {
  Q_OBJECT

 private slots:
  void givesBackWhatWasPut() {
    TileStore store;
    std::vector<TileStore::Key> keys;
    for (std::uint64_t i = 0; i < 20; ++i) {
      auto key = store.put(tileNumber(i, 100 + i));
      EXPECT_OK(key);
      QVERIFY(std::find(keys.begin(), keys.end(), key.value()) == keys.end());
      QVERIFY(key.value() != 0);
      keys.push_back(key.value());
    }
    for (std::uint64_t i = 0; i < 20; ++i) {
      const auto tile = store.get(keys[i]);
      EXPECT_OK(tile);
      QVERIFY(*tile.value() == tileNumber(i, 100 + i));
    }
    QCOMPARE(store.statistics().tilesWritten, std::uint64_t{0});
  }

  void spillsAndKeepsEveryByte() {
    TileStore store(3 * kTile);
    std::vector<TileStore::Key> keys;
    for (std::uint64_t i = 0; i < 50; ++i) {
      auto key = store.put(tileNumber(i));
      EXPECT_OK(key);
      keys.push_back(key.value());
      QVERIFY(store.statistics().bytesInMemory <= 3 * kTile);
    }
    QCOMPARE(store.statistics().bytesOnDisk, 47 * kTile);
    // Twice, in orders that defeat any cache.
    for (int round = 0; round < 2; ++round) {
      for (std::uint64_t i = 0; i < 50; ++i) {
        const std::uint64_t number = (i * 17 + 3) % 50;
        const auto tile = store.get(keys[number]);
        EXPECT_OK(tile);
        QVERIFY(*tile.value() == tileNumber(number));
        QVERIFY(store.statistics().bytesInMemory <= 3 * kTile);
      }
    }
    QVERIFY(store.statistics().tilesReadBack > 50);
    // Tiles never change, so each goes to the disk once.
    QVERIFY(store.statistics().tilesWritten <= 50);
  }

  void theLeastRecentlyUsedLeavesFirst() {
    TileStore store(2 * kTile);
    const auto a = store.put(tileNumber(1));
    const auto b = store.put(tileNumber(2));
    EXPECT_OK(store.get(a.value()));  // b is now the older one
    EXPECT_OK(store.put(tileNumber(3)));
    QCOMPARE(store.statistics().tilesWritten, std::uint64_t{1});
    EXPECT_OK(store.get(a.value()));
    QCOMPARE(store.statistics().tilesReadBack, std::uint64_t{0});
    EXPECT_OK(store.get(b.value()));
    QCOMPARE(store.statistics().tilesReadBack, std::uint64_t{1});
  }

  void aHeldTileStaysAndSurvivesItsRemoval() {
    TileStore store(kTile);
    const auto key = store.put(tileNumber(1));
    EXPECT_OK(key);
    auto held = store.get(key.value());
    EXPECT_OK(held);
    for (std::uint64_t i = 2; i < 10; ++i)
      EXPECT_OK(store.put(tileNumber(i)));
    // The tile is not written, since it would have stayed in memory anyway.
    QVERIFY(store.statistics().bytesInMemory <= 2 * kTile);
    QVERIFY(store.get(key.value()).value() == held.value());
    store.remove(key.value());
    QVERIFY(*held.value() == tileNumber(1));
  }

  void aBudgetSmallerThanOneTileStillWorks() {
    TileStore store(1);
    const auto a = store.put(tileNumber(1));
    const auto b = store.put(tileNumber(2));
    for (int round = 0; round < 3; ++round) {
      QVERIFY(*store.get(a.value()).value() == tileNumber(1));
      QVERIFY(*store.get(b.value()).value() == tileNumber(2));
      QVERIFY(store.statistics().bytesInMemory <= kTile);
    }
  }

  void removalFreesMemoryAndDisk() {
    TileStore store(2 * kTile);
    std::vector<TileStore::Key> keys;
    for (std::uint64_t i = 0; i < 10; ++i)
      keys.push_back(store.put(tileNumber(i)).value());
    for (const TileStore::Key key : keys)
      store.remove(key);
    store.remove(keys.front());  // twice does no harm
    const auto empty = store.statistics();
    QCOMPARE(empty.bytesInMemory, std::size_t{0});
    QCOMPARE(empty.bytesOnDisk, std::size_t{0});
    // Places on disk are used again and hold the new bytes.
    keys.clear();
    for (std::uint64_t i = 100; i < 110; ++i)
      keys.push_back(store.put(tileNumber(i)).value());
    for (std::uint64_t i = 0; i < 10; ++i) {
      QVERIFY(*store.get(keys[i]).value() == tileNumber(100 + i));
    }
  }

  void tilesOfDifferentSizesDoNotOverlapOnDisk() {
    TileStore store(1000);
    std::vector<std::pair<TileStore::Key, std::size_t>> tiles;
    Random random(5);
    for (std::uint64_t i = 0; i < 300; ++i) {
      const auto size = static_cast<std::size_t>(random.uniform(0.0, 700.0));
      tiles.push_back({store.put(tileNumber(i, size)).value(), size});
      if (i % 3 == 2) {
        store.remove(tiles[i / 2].first);
        tiles[i / 2].second = SIZE_MAX;
      }
    }
    for (std::uint64_t i = 0; i < tiles.size(); ++i) {
      if (tiles[i].second == SIZE_MAX) continue;
      QVERIFY(*store.get(tiles[i].first).value() == tileNumber(i, tiles[i].second));
    }
  }
};

class SpillFileTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { saved_ = qgetenv("TMPDIR"); }
  void cleanup() {
    if (saved_.isNull()) {
      qunsetenv("TMPDIR");
    } else {
      qputenv("TMPDIR", saved_);
    }
  }

  void leavesNothingBehind() {
    const QTemporaryDir folder;
    qputenv("TMPDIR", folder.path().toUtf8());
    TileStore store(kTile);
    for (std::uint64_t i = 0; i < 5; ++i)
      EXPECT_OK(store.put(tileNumber(i)));
    QVERIFY(store.statistics().bytesOnDisk > 0);
    QVERIFY(QDir(folder.path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
  }

  void readingPastTheEndFails() {
    auto file = SpillFile::create();
    EXPECT_OK(file);
    const TileBytes bytes = tileNumber(1);
    EXPECT_OK(file.value()->write(0, bytes));
    TileBytes more(kTile + 1);
    EXPECT_ERROR(file.value()->read(0, more), "TMPDIR");
    QVERIFY(file.value()->read(0, more).error().kind == ErrorKind::resource);
  }

  void aMissingFolderIsNamedAndNothingIsLost() {
    const QTemporaryDir folder;
    const QByteArray missing = folder.path().toUtf8() + "/missing";
    qputenv("TMPDIR", missing);
    TileStore store(kTile);
    const auto first = store.put(tileNumber(1));
    EXPECT_OK(first);
    const auto second = store.put(tileNumber(2));
    EXPECT_ERROR(second, "TMPDIR");
    QVERIFY(second.error().kind == ErrorKind::resource);
    QCOMPARE(second.error().place, missing.toStdString());
    QVERIFY(*store.get(first.value()).value() == tileNumber(1));
    // And once there is a place, all is well.
    qputenv("TMPDIR", folder.path().toUtf8());
    EXPECT_OK(store.put(tileNumber(2)));
    QVERIFY(*store.get(first.value()).value() == tileNumber(1));
  }

 private:
  QByteArray saved_;
};

CUTIS_TEST(TileStoreTest)
CUTIS_TEST(SpillFileTest)

}  // namespace
}  // namespace cutis

#include "tile_store_test.moc"
