#include "core/fit/table/search_solver.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "core/fit/table/search_index.h"

namespace cutis {
namespace {

template <typename Index>
class SearchSolver final : public PixelSolver {
 public:
  SearchSolver(Index index, const char* stage, std::shared_ptr<const ResponseModel> channels)
      : PixelSolver(std::move(channels)), index_(std::move(index)), stage_(stage) {}

  void solve(PixelRows<const float> channels, PixelRows<float> values,
             const SolveReport& report) const override {
    std::vector<double> pixel(channels.rowCount);
    for (std::size_t i = 0; i < channels.count; ++i) {
      for (std::size_t k = 0; k < pixel.size(); ++k)
        pixel[k] = double{channels.at(k, i)};
      const std::size_t entry = index_.nearest(index_.search().features(pixel));
      const ParameterVector parameters = index_.search().table().parameters(entry);
      for (std::size_t k = 0; k < kParameterCount; ++k) {
        values.at(k, i) = static_cast<float>(parameters[static_cast<Eigen::Index>(k)]);
      }
      report.states[i] = PixelState::solved;
      report.iterations[i] = 0;
    }
  }

  // A table knows the nearest entry and not how far the next one would do as well.
  bool hasDeviations() const override { return false; }
  void deviations(PixelRows<const float>, PixelRows<const float>, PixelRows<float>) const override {
  }
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
