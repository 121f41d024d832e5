#include "src/app/training/size_study.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>

#include "core/base/random.h"
#include "core/neural/network_pipeline.h"

namespace cutis {
namespace {

// Few enough that a run is over before another program gets the core.
constexpr std::size_t kPixels = 1 << 11;
constexpr int kRuns = 300;

using Planes = std::vector<std::vector<float>>;

Planes randomPlanes(int count) {
  Planes planes;
  for (int k = 0; k < count; ++k) {
    Random random(6, static_cast<std::uint64_t>(k));
    planes.emplace_back(kPixels);
    for (float& value : planes.back())
      value = static_cast<float>(random.uniform(0.05, 0.6));
  }
  return planes;
}

// Of one core.
double nanosecondsPerPixel(const NetworkPipeline& pipeline, const Planes& inputs,
                           bool wantsParameters) {
  Planes results(
      static_cast<std::size_t>(wantsParameters ? int{kParameterCount} : pipeline.outputCount()),
      std::vector<float>(kPixels));
  std::vector<const float*> in;
  for (const auto& plane : inputs)
    in.push_back(plane.data());
  std::vector<float*> out;
  for (auto& plane : results)
    out.push_back(plane.data());
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < kRuns; ++run) {
    const auto start = std::chrono::steady_clock::now();
    if (wantsParameters) {
      pipeline.run(kPixels, in, out, {});
    } else {
      pipeline.run(kPixels, in, {}, out);
    }
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
    least = std::min(least, took.count() / static_cast<double>(kPixels));
  }
  return least;
}

}  // namespace

Result<SizeFigures> studySize(const SkinModel& model, const Rig& rig,
                              const NetworkTraining& training, const JobContext& context) {
  NetworkTrainingState state;
  CUTIS_TRY(trained, trainNetworks(model, rig, training, state, context));
  CUTIS_TRY(errors, measureNetworks(model, rig, trained.file, context));
  const ChromophoreNetwork& chromophores = trained.file.chromophores;
  const auto encoder = NetworkPipeline::encoder(chromophores);
  CUTIS_TRY(both,
            NetworkPipeline::encoderDecoder(chromophores, trained.file.spectra, responseRows(rig)));
  const Planes inputs = randomPlanes(encoder.inputCount());
  SizeFigures figures;
  figures.weights =
      trained.file.spectra.network.parameterCount() + chromophores.network.parameterCount();
  figures.workPerPixel = both.workPerPixel();
  figures.encodeNanoseconds = nanosecondsPerPixel(encoder, inputs, true);
  figures.decodeNanoseconds = nanosecondsPerPixel(both, inputs, false);
  figures.errors = errors;
  figures.trainingSeconds = trained.seconds;
  return figures;
}

}  // namespace cutis
