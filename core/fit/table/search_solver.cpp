#include "core/fit/table/search_solver.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "core/fit/table/search_index.h"
#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

template <typename Index>
class SearchSolver final : public PixelSolver {
 public:
  SearchSolver(Index index, const char* stage, std::shared_ptr<const ResponseModel> channels)
      : PixelSolver(std::move(channels)), index_(std::move(index)), stage_(stage) {}

  void solve(const PixelBatch& batch, const SolveReport& report) const override {
    std::vector<double> channels(static_cast<std::size_t>(channelCount()));
    for (std::size_t i = 0; i < batch.count; ++i) {
      for (std::size_t k = 0; k < channels.size(); ++k) {
        channels[k] = double{batch.channels[k * batch.stride + i]};
      }
      const std::size_t entry = index_.nearest(index_.search().features(channels));
      const ParameterVector parameters = index_.search().table().parameters(entry);
      for (std::size_t k = 0; k < kParameterCount; ++k) {
        batch.parameters[k * batch.stride + i] =
            static_cast<float>(parameters[static_cast<Eigen::Index>(k)]);
      }
      report.states[i] = static_cast<std::uint8_t>(PixelState::solved);
      report.iterations[i] = 0;
    }
  }

  // A table knows the nearest entry and not how far the next one would do as well.
  bool hasDeviations() const override { return false; }
  void deviations(const PixelBatch&, float*) const override {}
  const char* stage() const override { return stage_; }

 private:
  Index index_;
  const char* stage_;
};

}  // namespace

std::unique_ptr<const PixelSolver> makeFullSearchSolver(
    std::shared_ptr<const TableSearch> search, std::shared_ptr<const ResponseModel> channels) {
  return std::make_unique<SearchSolver<FullSearchIndex>>(FullSearchIndex(std::move(search)),
                                                         "full search", std::move(channels));
}

std::unique_ptr<const PixelSolver> makeThreeStageSolver(
    std::shared_ptr<const TableSearch> search, int caroteneSample,
    std::shared_ptr<const ResponseModel> channels) {
  return std::make_unique<SearchSolver<ThreeStageIndex>>(
      ThreeStageIndex(std::move(search), caroteneSample), "three-stage search",
      std::move(channels));
}

}  // namespace cutis
