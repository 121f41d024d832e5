#include "core/fit/table/search_index.h"

#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace cutis {
namespace {

std::vector<std::uint32_t> allEntries(const SkinTable& table) {
  std::vector<std::uint32_t> entries(table.size());
  std::iota(entries.begin(), entries.end(), 0u);
  return entries;
}

std::vector<std::uint32_t> entriesWithCarotene(const SkinTable& table, int sample) {
  std::vector<std::uint32_t> entries;
  for (const std::uint32_t entry : allEntries(table)) {
    if (table.samples(entry)[kCarotene] == sample) entries.push_back(entry);
  }
  return entries;
}

NearestTree treeOf(const TableSearch& search, std::span<const int> features,
                   std::vector<std::uint32_t> entries) {
  std::vector<std::span<const float>> columns;
  for (const int feature : features)
    columns.push_back(search.featureOfEntries(feature));
  return NearestTree(columns, std::move(entries));
}

std::uint32_t nearestIn(const NearestTree& tree, const SearchFeatures& query,
                        std::span<const int> features) {
  std::array<float, kMaximumFeatures> values = {};
  for (std::size_t f = 0; f < features.size(); ++f) {
    values[f] = query[static_cast<std::size_t>(features[f])];
  }
  return tree.nearest(std::span(values).first(features.size()));
}

}  // namespace

FullSearchIndex::FullSearchIndex(std::shared_ptr<const TableSearch> search)
    : search_(std::move(search)),
      tree_(treeOf(*search_, search_->fullFeatures(), allEntries(search_->table()))) {}

std::size_t FullSearchIndex::nearest(const SearchFeatures& query) const {
  return nearestIn(tree_, query, search_->fullFeatures());
}

ThreeStageIndex::ThreeStageIndex(std::shared_ptr<const TableSearch> search, int caroteneSample)
    : search_(std::move(search)),
      firstStage_(treeOf(*search_, search_->firstStageFeatures(),
                         entriesWithCarotene(search_->table(), caroteneSample))) {}

std::size_t ThreeStageIndex::nearest(const SearchFeatures& query) const {
  const std::size_t first = nearestIn(firstStage_, query, search_->firstStageFeatures());
  return search_->laterStages(query, first);
}

}  // namespace cutis
