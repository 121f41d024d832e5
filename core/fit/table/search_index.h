#pragma once  // internal to core/fit/table

// The searches of TableSearch through exact indices: the same entries, ties included, about a
// hundred times as fast.

#include <cstddef>
#include <memory>
#include <optional>

#include "core/fit/table/nearest_tree.h"
#include "core/fit/table/table_search.h"

namespace cutis {

// Full search. Thread-safe: const after construction.
class FullSearchIndex {
 public:
  // Cost: about 0.2 s.
  explicit FullSearchIndex(std::shared_ptr<const TableSearch> search);

  const TableSearch& search() const { return *search_; }
  // What TableSearch::fullSearch() finds. About 2 µs.
  std::size_t nearest(const SearchFeatures& query) const;

 private:
  std::shared_ptr<const TableSearch> search_;
  NearestTree tree_;
};

// Three stages. The first searches an index of the entries with the fixed β-carotene; the others
// look at one block of the table, which is little enough as it is. Thread-safe: const after
// construction.
class ThreeStageIndex {
 public:
  // Cost: about 0.05 s.
  ThreeStageIndex(std::shared_ptr<const TableSearch> search, int caroteneSample);

  const TableSearch& search() const { return *search_; }
  // What TableSearch::threeStage() finds. About 2 µs.
  std::size_t nearest(const SearchFeatures& query) const;

 private:
  std::shared_ptr<const TableSearch> search_;
  NearestTree firstStage_;
};

}  // namespace cutis
