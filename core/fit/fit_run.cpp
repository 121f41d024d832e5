#include "core/fit/fit_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/base/parallel.h"
#include "core/fit/pixel_grouping.h"
#include "core/fit/tile_order.h"
#include "core/skin/pixel_state.h"

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

// Working memory of one tile: rows of tile.pixelCount() floats.
class TileFit {
 public:
  TileFit(const Measurements& measurements, const PixelSolver& solver, FitPlanes& planes,
          const Rect& rect)
      : measurements_(measurements),
        solver_(solver),
        planes_(planes),
        rect_(rect),
        pixelCount_(rect.pixelCount()),
        channelCount_(measurements.channels.size()),
        valueCount_(solver.valueCount()) {}

  Result<TileResult> run(const JobContext& context) {
    CUTIS_CHECK(load());
    collect();
    const PixelGrouping grouping =
        groupEqualPixels(channels_.data(), channelCount_, pixelCount_, pixels_);
    Solutions solutions = gather(grouping);
    for (std::size_t begin = 0; begin < solutions.count; begin += kRunBatch) {
      if (context.stopRequested()) return Cancelled{};
      solutions.solve(solver_, begin, std::min(kRunBatch, solutions.count - begin));
    }
    scatter(grouping, solutions);
    sampleResiduals(grouping, solutions);
    CUTIS_CHECK(store());
    return result_;
  }

 private:
  // Channels and results of the pixels to solve, packed.
  struct Solutions {
    std::size_t count = 0;
    std::vector<float> channels, parameters;
    std::vector<float> deviations, residuals, shading;  // if wanted
    std::vector<std::uint8_t> states;
    std::vector<std::uint16_t> iterations;

    void solve(const PixelSolver& solver, std::size_t begin, std::size_t size) {
      const PixelBatch batch = {size, count, channels.data() + begin, parameters.data() + begin};
      solver.solve(batch, {states.data() + begin, iterations.data() + begin});
      if (!deviations.empty()) solver.deviations(batch, deviations.data() + begin);
      if (!residuals.empty()) solver.residuals(batch, residuals.data() + begin);
      if (!shading.empty()) solver.shading(batch, shading.data() + begin);
    }
  };

  Status load() {
    channels_.resize(channelCount_ * pixelCount_);
    for (std::size_t k = 0; k < channelCount_; ++k) {
      CUTIS_CHECK(measurements_.loadChannel(k, rect_, row(channels_, k)));
    }
    states_.resize(pixelCount_);
    return measurements_.state.load(rect_, states_);
  }

  // Pixels there are to solve; counts the others.
  void collect() {
    result_.pixels.total = pixelCount_;
    std::vector<float> values(channelCount_);
    for (std::size_t i = 0; i < pixelCount_; ++i) {
      switch (static_cast<PixelState>(static_cast<int>(states_[i]))) {
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
      for (std::size_t k = 0; k < channelCount_; ++k)
        values[k] = channels_[k * pixelCount_ + i];
      if (classify(values, 1.0f, false) != PixelState::solved) {
        states_[i] = static_cast<float>(PixelState::invalid);
        ++result_.pixels.invalid;
        continue;
      }
      pixels_.push_back(static_cast<std::uint32_t>(i));
    }
  }

  Solutions gather(const PixelGrouping& grouping) const {
    Solutions solutions;
    solutions.count = grouping.representatives.size();
    solutions.channels.resize(channelCount_ * solutions.count);
    for (std::size_t k = 0; k < channelCount_; ++k) {
      for (std::size_t g = 0; g < solutions.count; ++g) {
        solutions.channels[k * solutions.count + g] =
            channels_[k * pixelCount_ + grouping.representatives[g]];
      }
    }
    solutions.parameters.resize(valueCount_ * solutions.count);
    solutions.states.resize(solutions.count);
    solutions.iterations.resize(solutions.count);
    if (!planes_.deviations.empty()) {
      solutions.deviations.resize(valueCount_ * solutions.count);
    }
    if (!planes_.residuals.empty()) solutions.residuals.resize(channelCount_ * solutions.count);
    if (!planes_.shading.empty()) solutions.shading.resize(solutions.count);
    return solutions;
  }

  void scatter(const PixelGrouping& grouping, const Solutions& solutions) {
    result_.pixels.solved = solutions.count;
    result_.pixels.duplicate = pixels_.size() - solutions.count;
    for (const std::uint16_t n : solutions.iterations) {
      result_.iterations += n;
      result_.maximumIterations = std::max(result_.maximumIterations, int{n});
    }
    values_.assign(valueCount_ * pixelCount_, 0.0f);
    spread(grouping, solutions.parameters, solutions.count, valueCount_, values_);
    if (!planes_.deviations.empty()) {
      deviations_.assign(valueCount_ * pixelCount_, 0.0f);
      spread(grouping, solutions.deviations, solutions.count, valueCount_, deviations_);
    }
    if (!planes_.residuals.empty()) {
      residuals_.assign(channelCount_ * pixelCount_, 0.0f);
      spread(grouping, solutions.residuals, solutions.count, channelCount_, residuals_);
    }
    if (!planes_.shading.empty()) {
      shading_.assign(pixelCount_, 0.0f);
      spread(grouping, solutions.shading, solutions.count, 1, shading_);
    }
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const std::uint32_t group = grouping.groupOf[i];
      states_[pixels_[i]] = solutions.states[group];
      if (solutions.states[group] == static_cast<int>(PixelState::noConvergence)) {
        ++result_.pixels.noConvergence;
      }
    }
  }

  void spread(const PixelGrouping& grouping, const std::vector<float>& from, std::size_t stride,
              std::size_t rows, std::vector<float>& to) const {
    for (std::size_t k = 0; k < rows; ++k) {
      for (std::size_t i = 0; i < pixels_.size(); ++i) {
        to[k * pixelCount_ + pixels_[i]] = from[k * stride + grouping.groupOf[i]];
      }
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
    const auto pick = [&](const std::vector<float>& rows, std::size_t rowCount) {
      std::vector<float> picked;
      for (std::size_t k = 0; k < rowCount; ++k) {
        for (const std::uint32_t group : groups)
          picked.push_back(rows[k * solutions.count + group]);
      }
      return picked;
    };
    const std::vector<float> channels = pick(solutions.channels, channelCount_);
    std::vector<float> parameters = pick(solutions.parameters, valueCount_);
    std::vector<float> residuals(channels.size());
    solver_.residuals({groups.size(), groups.size(), channels.data(), parameters.data()},
                      residuals.data());
    for (std::size_t i = 0; i < groups.size(); ++i) {
      double sum = 0.0;
      for (std::size_t k = 0; k < channelCount_; ++k) {
        const double r = residuals[k * groups.size() + i];
        sum += r * r;
      }
      result_.residuals.push_back(
          static_cast<float>(std::sqrt(sum / static_cast<double>(channelCount_))));
    }
  }

  Status store() {
    std::vector<Plane> values = planes_.maps.planes();
    for (std::size_t k = 0; k < valueCount_; ++k) {
      CUTIS_CHECK(values[k].store(rect_, row(values_, k)));
      if (!planes_.deviations.empty()) {
        CUTIS_CHECK(planes_.deviations[k].store(rect_, row(deviations_, k)));
      }
    }
    for (std::size_t k = 0; k < planes_.residuals.size(); ++k) {
      CUTIS_CHECK(planes_.residuals[k].store(rect_, row(residuals_, k)));
    }
    if (!planes_.shading.empty()) CUTIS_CHECK(planes_.shading.store(rect_, shading_));
    return planes_.maps.state.store(rect_, states_);
  }

  std::span<float> row(std::vector<float>& values, std::size_t k) const {
    return std::span<float>(values).subspan(k * pixelCount_, pixelCount_);
  }

  const Measurements& measurements_;
  const PixelSolver& solver_;
  FitPlanes& planes_;
  const Rect rect_;
  const std::size_t pixelCount_;
  const std::size_t channelCount_;
  const std::size_t valueCount_;
  std::vector<float> channels_, states_, values_, deviations_, residuals_, shading_;
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
    const auto at = residuals.begin() + static_cast<std::ptrdiff_t>(0.95 * (count - 1.0));
    std::nth_element(residuals.begin(), at, residuals.end());
    total.residual95 = *at;
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
