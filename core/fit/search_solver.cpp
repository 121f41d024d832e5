#include "core/fit/search_solver.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

// Pixels that pass over the table together.
constexpr std::size_t kGroup = 64;

class SearchSolver : public PixelSolver {
 public:
  SearchSolver(std::shared_ptr<const TableSearch> search, std::shared_ptr<const SkinModel> model,
                                                        const Rig& rig)
      : search_(std::move(search)),
        model_(std::move(model)),
        rows_(responseRows(rig)) {}

  void solve(const SolveBatch& batch) const override {
    std::vector<SearchFeatures> queries;
    std::vector<std::size_t> entries;
    std::vector<double> channels(static_cast<std::size_t>(rows_.rows()));
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
      for (std::size_t i = begin; i < end; ++i) write(batch, i, entries[i - begin]);
    }
  }

 protected:
  virtual void find(std::span<const SearchFeatures> queries,
                    std::span<std::size_t> entries) const = 0;
  const TableSearch& search() const { return *search_; }

 private:
  void write(const SolveBatch& batch, std::size_t i, std::size_t entry) const {
    const ParameterVector parameters = search_->table().parameters(entry);
    for (int k = 0; k < kParameterCount; ++k) {
      batch.parameters[static_cast<std::size_t>(k) * batch.stride + i] =
          static_cast<float>(parameters[k]);
    }
    batch.states[i] = static_cast<std::uint8_t>(PixelState::solved);
    batch.iterations[i] = 0;
    if (batch.residuals == nullptr) return;
    const Eigen::VectorXd modelled = rows_.matrix() * model_->reflectance(parameters).matrix();
    for (Eigen::Index k = 0; k < modelled.size(); ++k) {
      const std::size_t at = static_cast<std::size_t>(k) * batch.stride + i;
      batch.residuals[at] = static_cast<float>(double{batch.channels[at]} - modelled[k]);
    }
  }

  std::shared_ptr<const TableSearch> search_;
  std::shared_ptr<const SkinModel> model_;
  SpectrumRows rows_;
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
                   std::shared_ptr<const SkinModel> model,
                                                        const Rig& rig)
      : SearchSolver(std::move(table), std::move(model), rig), caroteneSample_(caroteneSample) {}
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

std::unique_ptr<const PixelSolver> makeFullSearchSolver(std::shared_ptr<const TableSearch> search,
                                                        std::shared_ptr<const SkinModel> model,
                                                        const Rig& rig) {
  return std::make_unique<FullSearchSolver>(std::move(search), std::move(model), rig);
}

std::unique_ptr<const PixelSolver> makeThreeStageSolver(std::shared_ptr<const TableSearch> search,
                                                        int caroteneSample,
                                                        std::shared_ptr<const SkinModel> model,
                                                        const Rig& rig) {
  return std::make_unique<ThreeStageSolver>(std::move(search), caroteneSample, std::move(model), rig);
}

}  // namespace cutis
