#include "tests/core/neural/neural_fixture.h"

#include <cstdio>
#include <cstdlib>

#include "tests/support/models.h"

namespace cutis::test {
namespace {

template <typename T>
T require(Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "%s\n", result.failed() ? result.error().text().c_str() : "cancelled");
    std::abort();
  }
  return std::move(result).value();
}

}  // namespace

const SpectraBasis& sampledBasis() {
  static const SpectraBasis basis = require(computeSpectraBasis(li2024(), {}, 97));
  return basis;
}

SpectraNetworkOptions quickSpectraOptions() {
  SpectraNetworkOptions options;
  options.hidden = {24, 24};
  options.components = 12;
  options.people.count = 20'000;
  options.trainer.epochs = 25;
  options.trainer.batch = 192;
  return options;
}

ChromophoreNetworkOptions quickChromophoreOptions() {
  ChromophoreNetworkOptions options;
  options.hidden = {24, 24};
  options.people.count = 20'000;
  options.trainer.epochs = 25;
  options.trainer.batch = 192;
  return options;
}

const SpectraNetwork& quickSpectraNetwork() {
  static const SpectraNetwork network = [] {
    TrainingState state;
    return require(trainSpectraNetwork(li2024(), sampledBasis(), quickSpectraOptions(), state, {}));
  }();
  return network;
}

const ChromophoreNetwork& quickChromophoreNetwork() {
  static const ChromophoreNetwork network = [] {
    TrainingState state;
    return require(trainChromophoreNetwork(li2024(), networkChannels(monitorRig()),
                                           quickSpectraNetwork(), quickChromophoreOptions(), state,
                                           {}));
  }();
  return network;
}

PixelRows<const float> rowsOf(const Eigen::MatrixXf& pixels) {
  return packedRows(pixels.data(), static_cast<std::size_t>(pixels.cols()),
                    static_cast<std::size_t>(pixels.rows()));
}

PixelRows<float> rowsOf(Eigen::MatrixXf& pixels) {
  return packedRows(pixels.data(), static_cast<std::size_t>(pixels.cols()),
                    static_cast<std::size_t>(pixels.rows()));
}

}  // namespace cutis::test
