#include "src/app/training/size_study.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "core/base/random.h"
#include "core/neural/network_pipeline.h"

namespace cutis {
namespace {

// Few enough that a run is over before another program gets the core.
constexpr std::size_t kPixels = 1 << 11;
constexpr int kRuns = 300;

PixelBuffer<float> randomInputs(int count) {
  PixelBuffer<float> inputs(static_cast<std::size_t>(count), kPixels);
  for (std::size_t k = 0; k < inputs.rowCount(); ++k) {
    Random random(6, k);
    for (float& value : inputs[k])
      value = static_cast<float>(random.uniform(0.05, 0.6));
  }
  return inputs;
}

// Measured on one core.
double nanosecondsPerPixel(const NetworkPipeline& pipeline, const PixelBuffer<float>& inputs,
                           bool wantsParameters) {
  PixelBuffer<float> results(
      static_cast<std::size_t>(wantsParameters ? int{kParameterCount} : pipeline.outputCount()),
      kPixels);
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < kRuns; ++run) {
    const auto start = std::chrono::steady_clock::now();
    if (wantsParameters) {
      pipeline.run(inputs.rows(), results.rows(), {});
    } else {
      pipeline.run(inputs.rows(), {}, results.rows());
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
  const PixelBuffer<float> inputs = randomInputs(encoder.inputCount());
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
