#include "src/cli/bench_pictures.h"

#include <algorithm>
#include <chrono>

#include <tbb/global_control.h>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/fit/fit_run.h"
#include "core/simulate/photograph.h"
#include "core/simulate/skin_patch.h"
#include "src/app/gamut.h"
#include "src/files/platform.h"

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

Result<Measurements> pictureOf(const BenchSubject& subject, bool sample, int size,
                               Session& session) {
  const JobContext silent = {session.context.stop, {}, {}};
  if (sample) {
    CUTIS_TRY(skin, simulateSkin(SkinRecipe(), size, size, kSeed, subject.model->profile().axes,
                                 session.store, silent));
    return photograph(skin, *subject.model, subject.rig, kUsualNoise, kSeed, silent);
  }
  CUTIS_TRY(maps, uncorrelatedMaps(size, silent));
  return photograph(maps, *subject.model, subject.rig, kUsualNoise, kSeed, silent);
}

// Fits the picture, as often as asked; the fastest run counts.
Result<PictureFigures> fitPicture(const Measurements& picture, const PixelSolver& solver,
                                  int repeats, Session& session) {
  using Clock = std::chrono::steady_clock;
  const JobContext silent = {session.context.stop, {}, {}};
  PictureFigures figures;
  figures.size = picture.width();
  for (int run = 0; run < repeats; ++run) {
    const auto start = Clock::now();
    const FitPlanes planes(picture, {}, session.store);
    CUTIS_TRY(statistics, runFit(picture, solver, planes, silent));
    CUTIS_TRY(gamut, measureGamut(picture, planes.maps, solver, {}, silent));
    static_cast<void>(gamut);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    figures.seconds = run == 0 ? seconds : std::min(figures.seconds, seconds);
    figures.solved = statistics.pixels.solved;
    figures.duplicate = statistics.pixels.duplicate;
    figures.meanIterations = statistics.meanIterations;
  }
  figures.threads = allowedThreads();
  figures.peakMemoryBytes = peakMemoryBytes();
  return figures;
}

PictureFigures scaledPicture(const BenchFigures& figures, BenchMethod method, int size) {
  PictureFigures picture;
  picture.size = size;
  picture.threads = figures.threads;
  picture.scaled = true;
  if (const auto* known = figuresOf(figures.methods, method, kUsualNoise))
    picture.seconds = 1e-9 * known->nanosecondsPerPixel * size * size;
  return picture;
}

Status runSizes(const BenchSubject& subject, const PictureSeries& series, Session& session,
                BenchSolvers& solvers, const JobContext& context, BenchFigures& figures) {
  for (const int size : series.sizes) {
    context.progress.report(0.5 * size / series.sizes.back());
    for (const bool sample : {false, true}) {
      CUTIS_TRY(picture, pictureOf(subject, sample, size, session));
      for (const BenchMethod method : kBenchMethods) {
        // Every pixel of the sample is another one too: what is slow is not run on it.
        if (sample && !isRefined(method)) continue;
        const bool fast =
            method == BenchMethod::refinedWide || method == BenchMethod::refinedPopulation;
        const bool search = method == BenchMethod::threeStage || method == BenchMethod::fullSearch;
        const bool run = fast || (search && size <= series.largestSearch);
        if (sample && !run) continue;
        CUTIS_TRY(solver, solvers.solver(method, kUsualNoise));
        PictureFigures row = scaledPicture(figures, method, size);
        if (run) {
          CUTIS_TRY(fitted, fitPicture(picture, *solver, fast ? kRepeats : 1, session));
          row = fitted;
        }
        row.content = sample ? "sample" : "uncorrelated";
        row.method = method;
        figures.sizes.push_back(row);
      }
    }
  }
  return {};
}

Status runScaling(const BenchSubject& subject, const PictureSeries& series, Session& session,
                  BenchSolvers& solvers, const JobContext& context, BenchFigures& figures) {
  CUTIS_TRY(picture, pictureOf(subject, false, series.scalingSize, session));
  CUTIS_TRY(solver, solvers.solver(BenchMethod::refinedWide, kUsualNoise));
  const int most = allowedThreads();
  for (int threads = 1;; threads = std::min(2 * threads, most)) {
    context.progress.report(static_cast<double>(threads) / most);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    CUTIS_TRY(fitted, fitPicture(picture, *solver, kRepeats, session));
    fitted.content = "uncorrelated";
    fitted.method = BenchMethod::refinedWide;
    figures.scaling.push_back(fitted);
    if (threads == most) return {};
  }
}

}  // namespace

int allowedThreads() {
  const auto allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(parallelThreadCount(), static_cast<int>(allowed));
}

Status runPictures(const BenchSubject& subject, const PictureSeries& series, Session& session,
                   BenchSolvers& solvers, const JobContext& context, BenchFigures& figures) {
  // Sizes first: memory only ever grows.
  CUTIS_CHECK(runSizes(subject, series, session, solvers, context.child(0.0, 0.8), figures));
  return runScaling(subject, series, session, solvers, context.child(0.8, 1.0), figures);
}

}  // namespace cutis
