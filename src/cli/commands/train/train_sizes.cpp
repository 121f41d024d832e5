#include "src/cli/commands/train/train_sizes.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

#include "core/base/random.h"
#include "core/neural/network_pipeline.h"
#include "src/app/training/network_errors.h"
#include "src/cli/options/train_options.h"
#include "src/cli/text_table.h"

namespace cutis {
namespace {

constexpr std::size_t kMostSizes = 20;
// Few enough that a run is over before another program gets the core.
constexpr std::size_t kPixels = 1 << 11;
constexpr int kRuns = 300;
constexpr char kDefaultSize[] = "default";

struct NetworkSize {
  std::string name;
  std::optional<std::vector<int>> hidden;  // none: as they are
};

Result<std::vector<NetworkSize>> sizesOf(const std::string& text) {
  std::vector<NetworkSize> sizes;
  std::istringstream fields(text);
  for (std::string field; std::getline(fields, field, ';');) {
    if (field == kDefaultSize) {
      sizes.push_back({field, {}});
      continue;
    }
    CUTIS_TRY(hidden, hiddenLayers("--sizes", field));
    sizes.push_back({field, hidden});
  }
  if (sizes.empty() || sizes.size() > kMostSizes) {
    return usageError("--sizes", "give 1 to " + std::to_string(kMostSizes) +
                                     " sizes with semicolons between them, such as "
                                     "\"16,16;default;64,64,64\"");
  }
  return sizes;
}

PixelBuffer<float> randomPlanes(int count) {
  PixelBuffer<float> planes(static_cast<std::size_t>(count), kPixels);
  for (std::size_t k = 0; k < planes.rowCount(); ++k) {
    Random random(6, k);
    for (float& value : planes[k])
      value = static_cast<float>(random.uniform(0.05, 0.6));
  }
  return planes;
}

// Of one core.
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

Result<std::vector<std::string>> rowOf(const NetworkSize& size, const SkinModel& model,
                                       const Rig& rig, NetworkTraining training,
                                       const JobContext& context) {
  if (size.hidden) training.spectra.hidden = training.chromophores.hidden = *size.hidden;
  NetworkTrainingState state;
  CUTIS_TRY(trained, trainNetworks(model, rig, training, state, context));
  CUTIS_TRY(errors, measureNetworks(model, rig, trained.file, context));
  const ChromophoreNetwork& chromophores = trained.file.chromophores;
  const auto encoder = NetworkPipeline::encoder(chromophores);
  CUTIS_TRY(both,
            NetworkPipeline::encoderDecoder(chromophores, trained.file.spectra, responseRows(rig)));
  const PixelBuffer<float> inputs = randomPlanes(encoder.inputCount());
  const auto weights =
      trained.file.spectra.network.parameterCount() + chromophores.network.parameterCount();
  return std::vector<std::string>{size.name,
                                  std::to_string(weights),
                                  std::to_string(both.workPerPixel()),
                                  fixedNumber(nanosecondsPerPixel(encoder, inputs, true), 0),
                                  fixedNumber(nanosecondsPerPixel(both, inputs, false), 0),
                                  shortScientific(errors.decoded),
                                  shortScientific(errors.encoded),
                                  shortScientific(errors.encodedNoisy),
                                  shortScientific(errors.both),
                                  fixedNumber(trained.seconds, 0)};
}

}  // namespace

Status checkSizes(const std::string& sizes) {
  const auto read = sizesOf(sizes);
  return read ? Status() : Status(read.failure());
}

Result<std::string> sizesTable(const std::string& sizes, const SkinModel& model, const Rig& rig,
                               const NetworkTraining& training, const JobContext& context) {
  CUTIS_TRY(list, sizesOf(sizes));
  TextTable table({"hidden layers", "weights", "multiply-adds", "encode, ns", "and decode, ns",
                   "SpectraNN", "ChromNN", "with noise", "both", "training, s"});
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto share = [&](std::size_t at) {
      return static_cast<double>(at) / static_cast<double>(list.size());
    };
    CUTIS_TRY(row, rowOf(list[i], model, rig, training, context.child(share(i), share(i + 1))));
    table.add(row);
  }
  return "  networks by size: weights of both; multiply-adds and time per pixel, one core, from "
         "channels to parameters\n  and on to the rig's channels; mean squared errors, 400-700 "
         "nm: SpectraNN; ChromNN and the skin model, without\n  and with the rig's noise; ChromNN "
         "and SpectraNN without noise\n" +
         table.text();
}

}  // namespace cutis
