// Run time of the vectorised forward model, per pixel, at 12 nodes spread over the visible.

#include <array>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/skin/model/reflectance_batch.h"
#include "core/skin/profile/parameter_sampling.h"
#include "tests/support/models.h"

namespace cutis {
namespace {

constexpr std::size_t kPixels = 4096;
const std::vector<int> kNodes = {52, 62, 72, 82, 92, 104, 116, 128, 138, 148, 160, 180};

struct Fixture {
  Fixture()
      : model(test::li2024(), kNodes),
        parameters(parameterRows<float>(
            sampleBox(test::li2024().profile().axes, static_cast<int>(kPixels)))) {}
  CompiledModel model;
  PixelBuffer<float> parameters;
  PixelBuffer<float> value{kNodes.size(), kPixels}, epidermal = value, dermal = value;
};

void perPixel(benchmark::State& state) {
  state.counters["ns/pixel"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * kPixels * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void reflectance(benchmark::State& state) {
  Fixture f;
  for (auto _ : state) {
    reflectanceBatch<float>(f.model, f.parameters.rows(), f.value.rows());
    benchmark::ClobberMemory();
  }
  perPixel(state);
}
BENCHMARK(reflectance);

void reflectanceAndDerivatives(benchmark::State& state) {
  Fixture f;
  for (auto _ : state) {
    reflectanceBatch<float>(f.model, f.parameters.rows(), f.value.rows(), f.epidermal.rows(),
                            f.dermal.rows());
    benchmark::ClobberMemory();
  }
  perPixel(state);
}
BENCHMARK(reflectanceAndDerivatives);

}  // namespace
}  // namespace cutis

BENCHMARK_MAIN();
