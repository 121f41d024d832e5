#include "core/fit/fit_run.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>

#include "core/base/parallel.h"
#include "core/fit/pixel_grouping.h"
#include "core/fit/tile_order.h"
#include "core/maths/quantile.h"

namespace cutis {
namespace {

// Pixels handed to the solver between two looks at the stop token.
constexpr std::size_t kRunBatch = 256;
constexpr int kResidualStep = 8;

struct TileResult {
  FitStatistics::Pixels pixels;
  std::uint64_t iterations = 0;
  int maximumIterations = 0;
  std::vector<float> residuals;  // sampled, per pixel
};

// Working memory of one tile: rows of its pixels.
class TileFit {
 public:
  TileFit(const Measurements& measurements, const PixelSolver& solver, FitPlanes& planes,
          const Rect& rect)
      : measurements_(measurements),
        solver_(solver),
        planes_(planes),
        rect_(rect),
        channels_(measurements.channels.size(), rect.pixelCount()),
        states_(rect.pixelCount()) {}

  Result<TileResult> run(const JobContext& context) {
    CUTIS_CHECK(load());
    collect();
    const PixelGrouping grouping = groupEqualPixels(channels_.rows(), pixels_);
    Solutions solutions = gather(grouping);
    for (std::size_t begin = 0; begin < solutions.count(); begin += kRunBatch) {
      if (context.stopRequested()) return Cancelled{};
      solutions.solve(solver_, begin, std::min(kRunBatch, solutions.count() - begin));
    }
    count(grouping, solutions);
    sampleResiduals(grouping, solutions);
    CUTIS_CHECK(store(grouping, solutions));
    return result_;
  }

 private:
  // Channels and results of the pixels to solve, packed.
  struct Solutions {
    PixelBuffer<float> channels, values;
    PixelBuffer<float> deviations, residuals, shading;  // if wanted
    std::vector<PixelState> states;
    std::vector<std::uint16_t> iterations;

    std::size_t count() const { return states.size(); }

    void solve(const PixelSolver& solver, std::size_t begin, std::size_t size) {
      const PixelRows<const float> measured = channels.rows().part(begin, size);
      const PixelRows<float> found = values.rows().part(begin, size);
      solver.solve(measured, found, {states.data() + begin, iterations.data() + begin});
      if (!deviations.empty())
        solver.deviations(measured, found, deviations.rows().part(begin, size));
      if (!residuals.empty()) solver.residuals(measured, found, residuals.rows().part(begin, size));
      if (!shading.empty()) solver.shading(measured, found, shading[0].data() + begin);
    }
  };

  Status load() {
    for (std::size_t k = 0; k < channels_.rowCount(); ++k) {
      CUTIS_CHECK(measurements_.loadChannel(k, rect_, channels_[k]));
    }
    return measurements_.state.load(rect_, states_);
  }

  // Pixels there are to solve; counts the others.
  void collect() {
    result_.pixels.total = states_.size();
    std::vector<float> pixel(channels_.rowCount());
    const PixelRows<const float> channels = channels_.rows();
    for (std::size_t i = 0; i < states_.size(); ++i) {
      switch (pixelState(states_[i])) {
        case PixelState::masked:
          ++result_.pixels.masked;
          continue;
        case PixelState::invalid:
          ++result_.pixels.invalid;
          continue;
        case PixelState::saturated:
          ++result_.pixels.saturated;
          continue;
        case PixelState::solved:
        case PixelState::noConvergence:
          break;
      }
      for (std::size_t k = 0; k < pixel.size(); ++k)
        pixel[k] = channels.at(k, i);
      if (classify(pixel, 1.0f, false) != PixelState::solved) {
        states_[i] = storedState(PixelState::invalid);
        ++result_.pixels.invalid;
        continue;
      }
      pixels_.push_back(static_cast<std::uint32_t>(i));
    }
  }

  Solutions gather(const PixelGrouping& grouping) const {
    const std::size_t count = grouping.representatives.size();
    Solutions solutions;
    solutions.channels = picked(channels_, grouping.representatives);
    solutions.values = PixelBuffer<float>(solver_.valueCount(), count);
    solutions.states.resize(count);
    solutions.iterations.resize(count);
    if (!planes_.deviations.empty()) solutions.deviations = solutions.values;
    if (!planes_.residuals.empty()) {
      solutions.residuals = PixelBuffer<float>(channels_.rowCount(), count);
    }
    if (!planes_.shading.empty()) solutions.shading = PixelBuffer<float>(1, count);
    return solutions;
  }

  void count(const PixelGrouping& grouping, const Solutions& solutions) {
    result_.pixels.solved = solutions.count();
    result_.pixels.duplicate = pixels_.size() - solutions.count();
    for (const std::uint16_t n : solutions.iterations) {
      result_.iterations += n;
      result_.maximumIterations = std::max(result_.maximumIterations, int{n});
    }
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const PixelState state = solutions.states[grouping.groupOf[i]];
      states_[pixels_[i]] = storedState(state);
      if (state == PixelState::noConvergence) ++result_.pixels.noConvergence;
    }
  }

  // Residuals of a regular sample of pixels, for the statistics.
  void sampleResiduals(const PixelGrouping& grouping, const Solutions& solutions) {
    const auto width = static_cast<std::uint32_t>(rect_.width());
    std::vector<std::uint32_t> groups;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const int x = rect_.x0 + static_cast<int>(pixels_[i] % width);
      const int y = rect_.y0 + static_cast<int>(pixels_[i] / width);
      if (x % kResidualStep == 0 && y % kResidualStep == 0) groups.push_back(grouping.groupOf[i]);
    }
    const PixelBuffer<float> channels = picked(solutions.channels, groups);
    const PixelBuffer<float> values = picked(solutions.values, groups);
    PixelBuffer<float> residuals(channels.rowCount(), groups.size());
    solver_.residuals(channels.rows(), values.rows(), residuals.rows());
    for (std::size_t i = 0; i < groups.size(); ++i) {
      double sum = 0.0;
      for (std::size_t k = 0; k < residuals.rowCount(); ++k) {
        const double r = residuals[k][i];
        sum += r * r;
      }
      result_.residuals.push_back(
          static_cast<float>(std::sqrt(sum / static_cast<double>(residuals.rowCount()))));
    }
  }

  Status store(const PixelGrouping& grouping, const Solutions& solutions) {
    std::vector<Plane> values = planes_.maps.planes();
    CUTIS_CHECK(spread(grouping, solutions.values, values));
    CUTIS_CHECK(spread(grouping, solutions.deviations, planes_.deviations));
    CUTIS_CHECK(spread(grouping, solutions.residuals, planes_.residuals));
    if (!planes_.shading.empty()) {
      CUTIS_CHECK(spread(grouping, solutions.shading, std::span(&planes_.shading, 1)));
    }
    return planes_.maps.state.store(rect_, states_);
  }

  // A plane a row; 0 where nothing was solved.
  Status spread(const PixelGrouping& grouping, const PixelBuffer<float>& from,
                std::span<Plane> planes) const {
    std::vector<float> pixels(rect_.pixelCount());
    for (std::size_t k = 0; k < planes.size(); ++k) {
      const std::span<const float> row = from[k];
      for (std::size_t i = 0; i < pixels_.size(); ++i)
        pixels[pixels_[i]] = row[grouping.groupOf[i]];
      CUTIS_CHECK(planes[k].store(rect_, pixels));
    }
    return {};
  }

  static PixelBuffer<float> picked(const PixelBuffer<float>& from,
                                   const std::vector<std::uint32_t>& pixels) {
    PixelBuffer<float> to(from.rowCount(), pixels.size());
    for (std::size_t k = 0; k < from.rowCount(); ++k) {
      const std::span<const float> source = from[k];
      const std::span<float> target = to[k];
      for (std::size_t i = 0; i < pixels.size(); ++i)
        target[i] = source[pixels[i]];
    }
    return to;
  }

  const Measurements& measurements_;
  const PixelSolver& solver_;
  FitPlanes& planes_;
  const Rect rect_;
  PixelBuffer<float> channels_;
  std::vector<float> states_;  // as they are stored
  std::vector<std::uint32_t> pixels_;
  TileResult result_;
};

FitStatistics combine(const std::vector<TileResult>& tiles) {
  FitStatistics total;
  std::uint64_t iterations = 0;
  std::vector<float> residuals;
  for (const TileResult& tile : tiles) {
    total.pixels.total += tile.pixels.total;
    total.pixels.masked += tile.pixels.masked;
    total.pixels.invalid += tile.pixels.invalid;
    total.pixels.saturated += tile.pixels.saturated;
    total.pixels.duplicate += tile.pixels.duplicate;
    total.pixels.solved += tile.pixels.solved;
    total.pixels.noConvergence += tile.pixels.noConvergence;
    iterations += tile.iterations;
    total.maximumIterations = std::max(total.maximumIterations, tile.maximumIterations);
    residuals.insert(residuals.end(), tile.residuals.begin(), tile.residuals.end());
  }
  if (total.pixels.solved > 0) {
    total.meanIterations =
        static_cast<double>(iterations) / static_cast<double>(total.pixels.solved);
  }
  if (!residuals.empty()) {
    const auto count = static_cast<double>(residuals.size());
    total.meanResidual = std::accumulate(residuals.begin(), residuals.end(), 0.0) / count;
    total.residual95 = quantileOf(residuals, 0.95);
  }
  return total;
}

}  // namespace

FitPlanes::FitPlanes(const Measurements& measurements, const FitOptions& options,
                     const std::shared_ptr<TileStore>& store)
    : maps(measurements.width(), measurements.height(), options.mapFormat, store, options.free) {
  const auto plane = [&] {
    return Plane(measurements.width(), measurements.height(), options.mapFormat, store);
  };
  if (options.deviations) {
    const int values = kParameterCount + options.free.count();
    for (int k = 0; k < values; ++k)
      deviations.push_back(plane());
  }
  if (options.shading) shading = plane();
  if (options.residuals) {
    for (std::size_t k = 0; k < measurements.channels.size(); ++k)
      residuals.push_back(plane());
  }
}

Result<FitStatistics> runFit(const Measurements& measurements, const PixelSolver& solver,
                             FitPlanes planes, const JobContext& context,
                             const FitObserver& observer) {
  const JobContext stage = context.child(0.0, 1.0, solver.stage());
  const auto tileCount = static_cast<std::size_t>(planes.maps.state.tileCount());
  std::vector<TileResult> tiles(tileCount);
  std::vector<Rect> rects;
  for (std::size_t i = 0; i < tileCount; ++i) {
    rects.push_back(planes.maps.state.tileRect(static_cast<int>(i)));
  }
  TileOrder order(rects);
  CUTIS_CHECK(parallelFor(tileCount, stage, [&](std::size_t) -> Status {
    const std::size_t i = order.next(observer.view ? observer.view() : Rect{});
    const Rect& rect = rects[i];
    CUTIS_TRY(tile, TileFit(measurements, solver, planes, rect).run(context));
    tiles[i] = std::move(tile);
    if (observer.finished) observer.finished(rect);
    return {};
  }));
  return combine(tiles);
}

}  // namespace cutis
