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
  Fixture() : model(test::li2024(), kNodes) {
    const auto points = sampleBox(test::li2024().profile().axes, kPixels);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      for (const ParameterVector& p : points) {
        columns[k].push_back(static_cast<float>(p[static_cast<Eigen::Index>(k)]));
      }
      batch.values[k] = columns[k].data();
    }
    batch.count = kPixels;
  }
  CompiledModel model;
  std::array<std::vector<float>, kParameterCount> columns;
  ParameterBatch<float> batch;
  std::vector<float> value = std::vector<float>(kPixels * kNodes.size());
  std::vector<float> epidermal = value;
  std::vector<float> dermal = value;
};

void perPixel(benchmark::State& state) {
  state.counters["ns/pixel"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * kPixels * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void reflectance(benchmark::State& state) {
  Fixture f;
  for (auto _ : state) {
    reflectanceBatch<float>(f.model, f.batch, f.value.data());
    benchmark::ClobberMemory();
  }
  perPixel(state);
}
BENCHMARK(reflectance);

void reflectanceAndDerivatives(benchmark::State& state) {
  Fixture f;
  for (auto _ : state) {
    reflectanceBatch<float>(f.model, f.batch, f.value.data(), f.epidermal.data(), f.dermal.data());
    benchmark::ClobberMemory();
  }
  perPixel(state);
}
BENCHMARK(reflectanceAndDerivatives);

}  // namespace
}  // namespace cutis

BENCHMARK_MAIN();
