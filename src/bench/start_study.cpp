#include "src/bench/start_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/evaluate/error_protocol.h"
#include "core/fit/coordinate_prior.h"
#include "core/fit/refined/fast_pass.h"

namespace cutis {
namespace {

using Eigen::Index;

constexpr std::uint64_t kStartNoiseSeed = 2;
constexpr std::size_t kStartBatch = 256;  // as in a fit

enum class Start { polynomial, network, priorMean };

const char* startNameOf(Start start) {
  switch (start) {
    case Start::polynomial:
      return "polynomial of its own";
    case Start::network:
      return "ChromNN's answer";
    case Start::priorMean:
      return "mean of the prior";
  }
  return "";
}

// The fit from one kind of start, with the usual noise, with the profile's own prior.
class StartedBy {
 public:
  // network: for Start::network.
  StartedBy(Start start, const SkinModel& model, const SpectralNodes& nodes,
            const PixelSolver* network)
      : start_(start),
        network_(network),
        prior_(coordinatePrior(model.profile().prior, model.profile().axes, {})),
        own_(model, nodes, model.profile().prior, {0.0, kUsualNoise}, {}),
        other_(model, nodes, model.profile().prior, {0.0, kUsualNoise}, {}) {
    other_.problem().tolerance = own_.problem().tolerance;
  }

  // Coordinates come out.
  void solve(const RefinedPixels<float>& pixels) const {
    if (start_ == Start::polynomial) return own_.solve(pixels);
    begin(pixels);
    runRefinedKernel(other_.problem(), pixels);
  }

  double parameter(int k, float coordinate) const {
    const double value{coordinate};
    return prior_.isLog[static_cast<std::size_t>(k)] ? std::exp(value) : value;
  }

 private:
  void begin(const RefinedPixels<float>& pixels) const {
    std::vector<PixelState> states(pixels.channels.count);
    if (start_ == Start::network)
      network_->solve(pixels.channels, pixels.coordinates, {states.data(), pixels.rounds});
    for (int k = 0; k < kParameterCount; ++k) {
      float* row = pixels.coordinates.row(static_cast<std::size_t>(k));
      for (std::size_t i = 0; i < pixels.channels.count; ++i) {
        const double value =
            start_ == Start::network ? prior_.coordinate(k, double{row[i]}) : prior_.mean[k];
        row[i] = static_cast<float>(value);
      }
    }
  }

  Start start_;
  const PixelSolver* network_;
  CoordinatePrior prior_;
  FastPass own_;
  RefinedProblemData<float> other_;  // without a start
};

Result<StartFigures> measure(const BenchSubject& subject, const ProtocolPixels& pixels,
                             const StartedBy& fit, const JobContext& context) {
  using Clock = std::chrono::steady_clock;
  const std::size_t count = pixels.count();
  const auto channels = pixels.photograph(kUsualNoise, kStartNoiseSeed);
  std::vector<float> values(kParameterCount * count);
  const auto measured = packedRows(channels.data(), pixels.channelCount(), count);
  const auto coordinates = packedRows(values.data(), kParameterCount, count);
  std::vector<std::uint8_t> converged(count);
  std::vector<std::uint16_t> rounds(count);
  double fastest = std::numeric_limits<double>::infinity();
  for (double passed = 0.0; passed == 0.0 || passed < subject.timingSeconds;) {
    std::fill(rounds.begin(), rounds.end(), std::uint16_t{0});
    const auto begin = Clock::now();
    CUTIS_CHECK(parallelFor((count + kStartBatch - 1) / kStartBatch, context,
                            [&](std::size_t piece) -> Status {
                              const std::size_t first = piece * kStartBatch;
                              const std::size_t size = std::min(kStartBatch, count - first);
                              fit.solve({measured.part(first, size), coordinates.part(first, size),
                                         converged.data() + first, rounds.data() + first});
                              return {};
                            }));
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    fastest = std::min(fastest, seconds);
    passed += std::max(seconds, 1e-9);
  }
  for (int k = 0; k < kParameterCount; ++k) {
    for (std::size_t i = 0; i < count; ++i) {
      float& value = values[static_cast<std::size_t>(k) * count + i];
      value = static_cast<float>(fit.parameter(k, value));
    }
  }
  CUTIS_TRY(errors, subject.meter->measure(pixels.people(), values, context));
  StartFigures figures;
  figures.visibleMse = summarise(errors).visibleMse;
  figures.nanosecondsPerPixel = 1e9 * fastest / static_cast<double>(count);
  for (const std::uint16_t n : rounds)
    figures.meanIterations += n / static_cast<double>(count);
  return figures;
}

}  // namespace

Status runStarts(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                 BenchFigures& figures) {
  CUTIS_TRY(pixels, ProtocolPixels::create(*subject.model, subject.rig, benchPeople(subject.pixels),
                                           context));
  CUTIS_TRY(refined, solvers.solver(BenchMethod::refinedWide, kUsualNoise));
  std::shared_ptr<const PixelSolver> network;
  if (solvers.has(BenchMethod::network)) {
    CUTIS_TRY(made, solvers.solver(BenchMethod::network, kUsualNoise));
    network = made;
  }
  for (const Start start : {Start::polynomial, Start::network, Start::priorMean}) {
    if (start == Start::network && network == nullptr) continue;
    const StartedBy fit(start, *subject.model, refined->nodes(), network.get());
    CUTIS_TRY(row, measure(subject, pixels, fit, context));
    row.start = startNameOf(start);
    figures.starts.push_back(row);
  }
  return {};
}

}  // namespace cutis
