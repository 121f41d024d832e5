#include "core/base/tile_store.h"

#include <cassert>
#include <utility>

namespace cutis {

Result<TileStore::Key> TileStore::put(TileBytes bytes) {
  const std::scoped_lock lock(mutex_);
  CUTIS_CHECK(makeRoom(bytes.size()));
  const Key key = nextKey_++;
  Entry entry;
  entry.size = bytes.size();
  entry.tile = std::make_shared<const TileBytes>(std::move(bytes));
  entry.use = use_.insert(use_.end(), key);
  statistics_.bytesInMemory += entry.size;
  entries_.emplace(key, std::move(entry));
  return key;
}

Result<TileHandle> TileStore::get(Key key) {
  const std::scoped_lock lock(mutex_);
  const auto found = entries_.find(key);
  assert(found != entries_.end());
  Entry& entry = found->second;
  if (entry.tile) {
    use_.splice(use_.end(), use_, entry.use);
    return entry.tile;
  }
  CUTIS_CHECK(makeRoom(entry.size));
  TileBytes bytes(entry.size);
  CUTIS_CHECK(file_->read(entry.offset, bytes));
  ++statistics_.tilesReadBack;
  entry.tile = std::make_shared<const TileBytes>(std::move(bytes));
  entry.use = use_.insert(use_.end(), key);
  statistics_.bytesInMemory += entry.size;
  return entry.tile;
}

void TileStore::remove(Key key) {
  const std::scoped_lock lock(mutex_);
  const auto found = entries_.find(key);
  if (found == entries_.end()) return;
  Entry& entry = found->second;
  if (entry.tile) {
    statistics_.bytesInMemory -= entry.size;
    use_.erase(entry.use);
  }
  if (entry.onDisk) {
    statistics_.bytesOnDisk -= entry.size;
    freeSlots_[entry.size].push_back(entry.offset);
  }
  entries_.erase(found);
}

TileStore::Statistics TileStore::statistics() const {
  const std::scoped_lock lock(mutex_);
  return statistics_;
}

Status TileStore::makeRoom(std::size_t incoming) {
  if (budgetBytes_ == kUnlimited) return {};
  auto candidate = use_.begin();
  while (candidate != use_.end() && statistics_.bytesInMemory + incoming > budgetBytes_) {
    Entry& entry = entries_.at(*candidate);
    // A tile that somebody holds would stay in memory anyway.
    if (entry.tile.use_count() > 1) {
      ++candidate;
      continue;
    }
    CUTIS_CHECK(writeOut(entry));
    entry.tile.reset();
    statistics_.bytesInMemory -= entry.size;
    candidate = use_.erase(candidate);
  }
  return {};
}

Status TileStore::writeOut(Entry& entry) {
  if (entry.onDisk) return {};
  if (!file_) {
    CUTIS_TRY(file, SpillFile::create());
    file_ = std::move(file);
  }
  const std::uint64_t offset = takeSlot(entry.size);
  const Status written = file_->write(offset, *entry.tile);
  if (!written) {
    freeSlots_[entry.size].push_back(offset);
    return written;
  }
  entry.offset = offset;
  entry.onDisk = true;
  statistics_.bytesOnDisk += entry.size;
  ++statistics_.tilesWritten;
  return {};
}

std::uint64_t TileStore::takeSlot(std::size_t size) {
  auto& slots = freeSlots_[size];
  if (!slots.empty()) {
    const std::uint64_t offset = slots.back();
    slots.pop_back();
    return offset;
  }
  return std::exchange(fileEnd_, fileEnd_ + size);
}

}  // namespace cutis
