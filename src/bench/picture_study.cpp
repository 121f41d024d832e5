#include "src/bench/picture_study.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include <tbb/global_control.h>

#include "core/analyse/gamut.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/fit/coarse_fit.h"
#include "core/fit/fit_run.h"
#include "core/simulate/photograph.h"
#include "core/simulate/skin_patch.h"
#include "src/files/system/platform.h"

namespace cutis {
namespace {

constexpr std::uint64_t kSeed = 5;
constexpr int kRepeats = 3;

// A number for each pixel and parameter, in [0, 1).
double uniformAt(std::uint64_t key, std::uint64_t pixel) {
  return static_cast<double>(mixBits(key + pixel) >> 11) * 0x1p-53;
}

// Every pixel a person of its own.
Result<ChromophoreMaps> uncorrelatedMaps(int size, const JobContext& context) {
  ChromophoreMaps maps(size, size);
  const ParameterBox box = protocolPopulation();
  CUTIS_CHECK(parallelFor(
      static_cast<std::size_t>(maps.state.tileCount()), context, [&](std::size_t i) -> Status {
        const Rect rect = maps.state.tileRect(static_cast<int>(i));
        std::vector<float> values(rect.pixelCount());
        for (std::size_t k = 0; k < kParameterCount; ++k) {
          const std::uint64_t key = mixBits(kSeed + k);
          const auto index = static_cast<Eigen::Index>(k);
          std::size_t n = 0;
          for (int y = rect.y0; y < rect.y1; ++y) {
            for (int x = rect.x0; x < rect.x1; ++x) {
              const auto pixel = static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(size) +
                                 static_cast<std::uint64_t>(x);
              values[n++] = static_cast<float>(box.low[index] + (box.high[index] - box.low[index]) *
                                                                    uniformAt(key, pixel));
            }
          }
          CUTIS_CHECK(maps.values[k].store(rect, values));
        }
        return {};
      }));
  return maps;
}

// What is in a picture, and how it was taken.
struct Content {
  const char* name;
  bool sample;
  double noise;
};
constexpr Content kNoisy = {"uncorrelated", false, kUsualNoise};
constexpr Content kNoiseFree = {"uncorrelated", false, 0.0};
constexpr Content kSample = {"sample", true, kUsualNoise};

Result<Measurements> pictureOf(const BenchSubject& subject, const Content& content, int size,
                               const JobContext& silent) {
  if (content.sample) {
    CUTIS_TRY(skin, simulateSkin(SkinRecipe(), size, size, kSeed, subject.model->profile().axes,
                                 subject.store, silent));
    return photograph(skin, *subject.model, subject.rig, content.noise, kSeed, silent);
  }
  CUTIS_TRY(maps, uncorrelatedMaps(size, silent));
  return photograph(maps, *subject.model, subject.rig, content.noise, kSeed, silent);
}

using SteadyClock = std::chrono::steady_clock;

double secondsSince(SteadyClock::time_point start) {
  return std::chrono::duration<double>(SteadyClock::now() - start).count();
}

// Fits the picture, as often as asked; the fastest run counts.
Result<PictureFigures> fitPicture(const BenchSubject& subject, const Measurements& picture,
                                  const PixelSolver& solver, int repeats,
                                  const JobContext& silent) {
  PictureFigures figures;
  figures.size = picture.width();
  const auto held = restartPeakMemory();
  for (int run = 0; run < repeats; ++run) {
    const auto start = SteadyClock::now();
    const FitPlanes planes(picture, {}, subject.store);
    CUTIS_TRY(statistics, runFit(picture, solver, planes, silent));
    CUTIS_TRY(pixels, judgePixels(picture, planes.maps, solver, {}, silent));
    static_cast<void>(gamutOf(pixels));
    const double seconds = secondsSince(start);
    figures.seconds = run == 0 ? seconds : std::min(figures.seconds, seconds);
    figures.solved = statistics.pixels.solved;
    figures.duplicate = statistics.pixels.duplicate;
    figures.meanIterations = statistics.meanIterations;
    if (run == 0 && held) figures.memoryBytes = std::max(peakMemoryBytes(), *held) - *held;
  }
  figures.threads = parallelThreadCount();
  return figures;
}

Result<FirstPictureFigures> firstPicture(const BenchSubject& subject, const Measurements& picture,
                                         const PixelSolver& solver, const JobContext& silent) {
  FirstPictureFigures figures;
  figures.size = picture.width();
  for (int run = 0; run < kRepeats; ++run) {
    const auto start = SteadyClock::now();
    const FitPlanes planes(picture, {}, subject.store);
    CUTIS_CHECK(runCoarseFit(picture, solver, planes.maps, silent));
    const double seconds = secondsSince(start);
    figures.seconds = run == 0 ? seconds : std::min(figures.seconds, seconds);
  }
  return figures;
}

PictureFigures scaledPicture(const BenchFigures& figures, BenchMethod method, double noise,
                             int size) {
  PictureFigures picture;
  picture.size = size;
  picture.threads = figures.threads;
  picture.scaled = true;
  if (const auto* known = figuresOf(figures.methods, method, noise))
    picture.seconds = 1e-9 * known->nanosecondsPerPixel * size * size;
  return picture;
}

bool isFast(BenchMethod method) {
  return method == BenchMethod::refinedWide || method == BenchMethod::refinedPopulation ||
         method == BenchMethod::network;
}

// Every pixel of the sample is another one too: what is slow is not run on it.
bool isRunOn(const Content& content, BenchMethod method) {
  if (content.noise == 0.0) return method == BenchMethod::refinedExact;
  return isFast(method) || (!content.sample && method != BenchMethod::refinedExact);
}

Status runContent(const BenchSubject& subject, const Content& content, int size,
                  const PictureSeries& series, MethodSolvers& solvers, const JobContext& silent,
                  BenchFigures& figures) {
  std::optional<Measurements> picture;
  for (const BenchMethod method : kBenchMethods) {
    if (!isRunOn(content, method) || !solvers.has(method)) continue;
    PictureFigures row = scaledPicture(figures, method, content.noise, size);
    if (isFast(method) || (!isExhaustive(method) && size <= series.largestSlow)) {
      if (!picture) {
        CUTIS_TRY(made, pictureOf(subject, content, size, silent));
        picture = std::move(made);
      }
      CUTIS_TRY(solver, solvers.solver(method, content.noise));
      CUTIS_TRY(fitted,
                fitPicture(subject, *picture, *solver, isFast(method) ? kRepeats : 1, silent));
      row = fitted;
      // Sizes increase: the last one stays.
      if (method == BenchMethod::refinedWide && !content.sample && size <= kUsualSize) {
        CUTIS_TRY(first, firstPicture(subject, *picture, *solver, silent));
        figures.firstPicture = first;
      }
    }
    row.content = content.name;
    row.noise = content.noise;
    row.method = method;
    figures.sizes.push_back(row);
  }
  return {};
}

}  // namespace

Status runSizes(const BenchSubject& subject, const PictureSeries& series, MethodSolvers& solvers,
                const JobContext& context, BenchFigures& figures) {
  const JobContext silent = {context.stop, {}, {}};
  double done = 0.0, all = 0.0;
  for (const int size : series.sizes)
    all += 1.0 * size * size;
  for (const int size : series.sizes) {
    for (const Content& content : {kNoisy, kNoiseFree, kSample}) {
      context.progress.report(done / all);
      CUTIS_CHECK(runContent(subject, content, size, series, solvers, silent, figures));
      done += 1.0 * size * size / 3.0;
    }
  }
  return {};
}

Status runScaling(const BenchSubject& subject, const PictureSeries& series, MethodSolvers& solvers,
                  const JobContext& context, BenchFigures& figures) {
  const JobContext silent = {context.stop, {}, {}};
  CUTIS_TRY(picture, pictureOf(subject, kNoisy, series.scalingSize, silent));
  CUTIS_TRY(solver, solvers.solver(BenchMethod::refinedWide, kUsualNoise));
  const int most = parallelThreadCount();
  for (int threads = 1;; threads = std::min(2 * threads, most)) {
    context.progress.report(static_cast<double>(threads) / most);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    CUTIS_TRY(fitted, fitPicture(subject, picture, *solver, kRepeats, silent));
    fitted.content = kNoisy.name;
    fitted.noise = kNoisy.noise;
    fitted.method = BenchMethod::refinedWide;
    figures.scaling.push_back(fitted);
    if (threads == most) return {};
  }
}

}  // namespace cutis
