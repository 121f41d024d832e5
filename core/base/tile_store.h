#pragma once

// Memory for tiles, within a budget.
//
// A tile is a block of bytes that never changes once it is in the store; to change a picture is to
// put a new tile in the place of the old one. Readers therefore need no lock while they look at
// one, and a view may show a picture that is being computed. When the tiles in memory exceed the
// budget, those unused for longest go to a temporary file and come back when asked for.
//
// Thread-safe. A tile that somebody holds stays in memory until it is let go, budget or not.

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "core/base/result.h"
#include "core/base/spill_file.h"

namespace cutis {

using TileBytes = std::vector<std::byte>;
using TileHandle = std::shared_ptr<const TileBytes>;

class TileStore {
 public:
  using Key = std::uint64_t;
  static constexpr std::size_t kUnlimited = SIZE_MAX;

  explicit TileStore(std::size_t budgetBytes = kUnlimited) : budgetBytes_(budgetBytes) {}
  TileStore(const TileStore&) = delete;
  TileStore& operator=(const TileStore&) = delete;

  // Stores a tile under a new key. Fails if there is no room on disk for what must leave memory.
  Result<Key> put(TileBytes bytes);
  // Precondition: key came from put() and was not removed.
  Result<TileHandle> get(Key key);
  void remove(Key key);

  struct Statistics {
    std::size_t bytesInMemory = 0;
    std::size_t bytesOnDisk = 0;
    std::uint64_t tilesWritten = 0;
    std::uint64_t tilesReadBack = 0;
  };
  Statistics statistics() const;

 private:
  struct Entry {
    TileHandle tile;  // null while on disk only
    std::size_t size = 0;
    std::uint64_t offset = 0;  // where on disk
    bool onDisk = false;
    std::list<Key>::iterator use;  // valid while in memory
  };

  Status makeRoom(std::size_t incoming);
  Status writeOut(Entry& entry);
  std::uint64_t takeSlot(std::size_t size);

  const std::size_t budgetBytes_;
  mutable std::mutex mutex_;
  std::unordered_map<Key, Entry> entries_;
  std::list<Key> use_;  // least recently used first
  std::unordered_map<std::size_t, std::vector<std::uint64_t>> freeSlots_;  // by size
  std::unique_ptr<SpillFile> file_;
  std::uint64_t fileEnd_ = 0;
  Key nextKey_ = 1;
  Statistics statistics_;
};

}  // namespace cutis
