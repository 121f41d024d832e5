#include "core/fit/fit_run.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <numeric>
#include <span>
#include <utility>

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

// Memory that grows and is used again: a tile's own is megabytes, and taking it from the system for
// each would cost as much as the fit.
class ReusedRows {
 public:
  // What is in them is of the last use.
  PixelRows<float> rows(std::size_t rowCount, std::size_t count) {
    if (memory_.size() < rowCount * count) memory_.resize(rowCount * count);
    return packedRows(memory_.data(), rowCount, count);
  }

 private:
  std::vector<float> memory_;
};

// Fits tiles, one after the other.
class TileFit {
 public:
  TileFit(const Measurements& measurements, const PixelSolver& solver, FitPlanes& planes)
      : measurements_(measurements), solver_(solver), planes_(planes) {}

  Result<TileResult> run(const Rect& rect, const JobContext& context) {
    rect_ = rect;
    result_ = {};
    CUTIS_CHECK(load());
    collect();
    grouping_ = groupEqualPixels(channels_, pixels_, std::move(grouping_));
    prepare();
    for (std::size_t begin = 0; begin < solvedCount(); begin += kRunBatch) {
      if (context.stopRequested()) return Cancelled{};
      solve(begin, std::min(kRunBatch, solvedCount() - begin));
    }
    count();
    sampleResiduals();
    CUTIS_CHECK(store());
    return std::move(result_);
  }

 private:
  Status load() {
    channels_ = channelMemory_.rows(measurements_.channels.size(), rect_.pixelCount());
    states_.resize(rect_.pixelCount());
    for (std::size_t k = 0; k < channels_.rowCount; ++k) {
      CUTIS_CHECK(measurements_.loadChannel(k, rect_, {channels_.row(k), channels_.count}));
    }
    return measurements_.state.load(rect_, states_);
  }

  // Pixels there are to solve; counts the others.
  void collect() {
    pixels_.clear();
    result_.pixels.total = states_.size();
    std::vector<float> pixel(channels_.rowCount);
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
        pixel[k] = channels_.at(k, i);
      if (classify(pixel, 1.0f, false) != PixelState::solved) {
        states_[i] = storedState(PixelState::invalid);
        ++result_.pixels.invalid;
        continue;
      }
      pixels_.push_back(static_cast<std::uint32_t>(i));
    }
  }

  // How many pixels are solved themselves.
  std::size_t solvedCount() const { return grouping_.representatives.size(); }

  // Room for the results of these, packed.
  void prepare() {
    const std::size_t count = solvedCount();
    values_ = valueMemory_.rows(solver_.valueCount(), count);
    solvedStates_.resize(count);
    iterations_.resize(count);
    if (!planes_.deviations.empty()) deviations_ = deviationMemory_.rows(values_.rowCount, count);
    if (!planes_.residuals.empty()) residuals_ = residualMemory_.rows(channels_.rowCount, count);
    if (!planes_.shading.empty()) shading_ = shadingMemory_.rows(1, count);
  }

  void solve(std::size_t begin, std::size_t size) {
    const auto pixels = std::span(grouping_.representatives).subspan(begin, size);
    const PixelRows<const float> measured = picked(channels_, pixels, batchMemory_);
    const PixelRows<float> found = values_.part(begin, size);
    solver_.solve(measured, found, {solvedStates_.data() + begin, iterations_.data() + begin});
    if (!planes_.deviations.empty())
      solver_.deviations(measured, found, deviations_.part(begin, size));
    if (!planes_.residuals.empty())
      solver_.residuals(measured, found, residuals_.part(begin, size));
    if (!planes_.shading.empty()) solver_.shading(measured, found, shading_.row(0) + begin);
  }

  void count() {
    result_.pixels.solved = solvedCount();
    result_.pixels.duplicate = pixels_.size() - solvedCount();
    for (const std::uint16_t n : iterations_) {
      result_.iterations += n;
      result_.maximumIterations = std::max(result_.maximumIterations, int{n});
    }
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const PixelState state = solvedStates_[grouping_.groupOf[i]];
      states_[pixels_[i]] = storedState(state);
      if (state == PixelState::noConvergence) ++result_.pixels.noConvergence;
    }
  }

  // Residuals of a regular sample of pixels, for the statistics.
  void sampleResiduals() {
    const auto width = static_cast<std::uint32_t>(rect_.width());
    std::vector<std::uint32_t> groups, pixels;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const int x = rect_.x0 + static_cast<int>(pixels_[i] % width);
      const int y = rect_.y0 + static_cast<int>(pixels_[i] / width);
      if (x % kResidualStep != 0 || y % kResidualStep != 0) continue;
      groups.push_back(grouping_.groupOf[i]);
      pixels.push_back(pixels_[i]);
    }
    const PixelRows<const float> values = picked(values_, groups, sampleMemory_);
    const PixelRows<const float> channels = picked(channels_, pixels, batchMemory_);
    PixelBuffer<float> residuals(channels.rowCount, groups.size());
    solver_.residuals(channels, values, residuals.rows());
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

  Status store() {
    std::vector<Plane> values = planes_.maps.planes();
    CUTIS_CHECK(spread(values_, values));
    CUTIS_CHECK(spread(deviations_, planes_.deviations));
    CUTIS_CHECK(spread(residuals_, planes_.residuals));
    if (!planes_.shading.empty()) CUTIS_CHECK(spread(shading_, std::span(&planes_.shading, 1)));
    return planes_.maps.state.store(rect_, states_);
  }

  // A plane a row; 0 where nothing was solved.
  Status spread(PixelRows<const float> from, std::span<Plane> planes) {
    plane_.assign(rect_.pixelCount(), 0.0f);
    for (std::size_t k = 0; k < planes.size(); ++k) {
      const float* row = from.row(k);
      for (std::size_t i = 0; i < pixels_.size(); ++i)
        plane_[pixels_[i]] = row[grouping_.groupOf[i]];
      CUTIS_CHECK(planes[k].store(rect_, plane_));
    }
    return {};
  }

  static PixelRows<const float> picked(PixelRows<const float> from,
                                       std::span<const std::uint32_t> pixels, ReusedRows& memory) {
    const PixelRows<float> to = memory.rows(from.rowCount, pixels.size());
    for (std::size_t k = 0; k < from.rowCount; ++k) {
      for (std::size_t i = 0; i < pixels.size(); ++i)
        to.at(k, i) = from.at(k, pixels[i]);
    }
    return to;
  }

  const Measurements& measurements_;
  const PixelSolver& solver_;
  FitPlanes& planes_;
  Rect rect_;
  TileResult result_;
  ReusedRows channelMemory_, valueMemory_, deviationMemory_, residualMemory_, shadingMemory_;
  ReusedRows batchMemory_, sampleMemory_;
  PixelRows<float> channels_;                          // of all pixels of the tile
  PixelRows<float> values_;                            // of the pixels that are solved themselves
  PixelRows<float> deviations_, residuals_, shading_;  // of these, if wanted
  std::vector<float> states_;                          // as they are stored
  std::vector<float> plane_;
  std::vector<std::uint32_t> pixels_;
  PixelGrouping grouping_;
  std::vector<PixelState> solvedStates_;
  std::vector<std::uint16_t> iterations_;
};

// One for each thread at work: whoever begins a tile borrows one.
class TileFits {
 public:
  TileFits(const Measurements& measurements, const PixelSolver& solver, FitPlanes& planes)
      : measurements_(measurements), solver_(solver), planes_(planes) {}

  Result<TileResult> run(const Rect& rect, const JobContext& context) {
    std::unique_ptr<TileFit> fit = borrow();
    Result<TileResult> result = fit->run(rect, context);
    const std::scoped_lock lock(mutex_);
    idle_.push_back(std::move(fit));
    return result;
  }

 private:
  std::unique_ptr<TileFit> borrow() {
    const std::scoped_lock lock(mutex_);
    if (idle_.empty()) return std::make_unique<TileFit>(measurements_, solver_, planes_);
    std::unique_ptr<TileFit> fit = std::move(idle_.back());
    idle_.pop_back();
    return fit;
  }

  const Measurements& measurements_;
  const PixelSolver& solver_;
  FitPlanes& planes_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<TileFit>> idle_;
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
  TileFits fits(measurements, solver, planes);
  CUTIS_CHECK(parallelFor(tileCount, stage, [&](std::size_t) -> Status {
    const std::size_t i = order.next(observer.view ? observer.view() : Rect{});
    const Rect& rect = rects[i];
    CUTIS_TRY(tile, fits.run(rect, context));
    tiles[i] = std::move(tile);
    if (observer.finished) observer.finished(rect);
    return {};
  }));
  return combine(tiles);
}

}  // namespace cutis
