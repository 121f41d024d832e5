#include "core/fit/search_solver.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

// Pixels that pass over the table together.
constexpr std::size_t kGroup = 64;

class SearchSolver : public PixelSolver {
 public:
  SearchSolver(std::shared_ptr<const TableSearch> search,
               std::shared_ptr<const ResponseModel> channels)
      : PixelSolver(std::move(channels)), search_(std::move(search)) {}

  void solve(const PixelBatch& batch, const SolveReport& report) const override {
    std::vector<SearchFeatures> queries;
    std::vector<std::size_t> entries;
    std::vector<double> channels(static_cast<std::size_t>(channelCount()));
    for (std::size_t begin = 0; begin < batch.count; begin += kGroup) {
      const std::size_t end = std::min(begin + kGroup, batch.count);
      queries.clear();
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t k = 0; k < channels.size(); ++k) {
          channels[k] = batch.channels[k * batch.stride + i];
        }
        queries.push_back(search_->features(channels));
      }
      entries.resize(queries.size());
      find(queries, entries);
      for (std::size_t i = begin; i < end; ++i) {
        const ParameterVector parameters = search_->table().parameters(entries[i - begin]);
        for (std::size_t k = 0; k < kParameterCount; ++k) {
          batch.parameters[k * batch.stride + i] =
              static_cast<float>(parameters[static_cast<Eigen::Index>(k)]);
        }
        report.states[i] = static_cast<std::uint8_t>(PixelState::solved);
        report.iterations[i] = 0;
      }
    }
  }

  // A table knows the nearest entry and not how far the next one would do as well.
  bool hasDeviations() const override { return false; }
  void deviations(const PixelBatch&, float*) const override {}

 protected:
  virtual void find(std::span<const SearchFeatures> queries,
                    std::span<std::size_t> entries) const = 0;
  const TableSearch& search() const { return *search_; }

 private:
  std::shared_ptr<const TableSearch> search_;
};

class FullSearchSolver final : public SearchSolver {
 public:
  using SearchSolver::SearchSolver;
  const char* stage() const override { return "full search"; }

 protected:
  void find(std::span<const SearchFeatures> queries,
            std::span<std::size_t> entries) const override {
    search().fullSearch(queries, entries);
  }
};

class ThreeStageSolver final : public SearchSolver {
 public:
  ThreeStageSolver(std::shared_ptr<const TableSearch> table, int caroteneSample,
                   std::shared_ptr<const ResponseModel> channels)
      : SearchSolver(std::move(table), std::move(channels)), caroteneSample_(caroteneSample) {}
  const char* stage() const override { return "three-stage search"; }

 protected:
  void find(std::span<const SearchFeatures> queries,
            std::span<std::size_t> entries) const override {
    for (std::size_t q = 0; q < queries.size(); ++q) {
      entries[q] = search().threeStage(queries[q], caroteneSample_);
    }
  }

 private:
  int caroteneSample_;
};

}  // namespace

std::unique_ptr<const PixelSolver> makeFullSearchSolver(
    std::shared_ptr<const TableSearch> search, std::shared_ptr<const ResponseModel> channels) {
  return std::make_unique<FullSearchSolver>(std::move(search), std::move(channels));
}

std::unique_ptr<const PixelSolver> makeThreeStageSolver(
    std::shared_ptr<const TableSearch> search, int caroteneSample,
    std::shared_ptr<const ResponseModel> channels) {
  return std::make_unique<ThreeStageSolver>(std::move(search), caroteneSample,
                                            std::move(channels));
}

}  // namespace cutis
