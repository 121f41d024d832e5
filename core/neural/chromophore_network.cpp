#include "core/neural/chromophore_network.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/maths/decompositions.h"
#include "core/neural/spectra_batch.h"
#include "core/neural/training_options.h"
#include "core/skin/profile/profile_signature.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Keeps the noise of a person apart from the draw of the person.
constexpr std::uint64_t kNoiseStream = std::uint64_t{1} << 40;
// Standard deviation of a log channel below which a direction is rounding.
constexpr double kLeastDeviation = 1e-4;

// Photographed channels of one person, with noise.
void photograph(const NoiseModel& noise, std::uint64_t seed, std::size_t person,
                Eigen::RowVectorXd& channels) {
  if (noise.isExact()) return;
  Random random(seed, kNoiseStream + person);
  const double level = random.uniform();
  for (double& y : channels) {
    y += level * std::hypot(noise.read, noise.proportional * y) * random.normal();
  }
}

// Logarithms of the inputs and weights of the components, one person a row.
struct Photographs {
  MatrixXd logInputs;
  Eigen::MatrixXf targets;
};

Result<Photographs> takePhotographs(const SkinModel& model, const NetworkChannels& channels,
                                    const SpectraNetwork& spectra,
                                    const ChromophoreNetworkOptions& options,
                                    const JobContext& context) {
  const std::vector<ParameterVector> people =
      drawTrainingPeople(options.people, model.profile().axes);
  const auto count = static_cast<Index>(people.size());
  const Eigen::MatrixXf rows = channels.rows.matrix().transpose().cast<float>();
  const Eigen::MatrixXf components = spectra.components.cast<float>();
  const Eigen::RowVectorXf mean = spectra.mean.matrix().transpose().cast<float>();
  Photographs result = {MatrixXd(count, channels.inputCount()),
                        Eigen::MatrixXf(count, components.cols())};
  const SpectraSource source(model);
  CUTIS_CHECK(
      source.forEachBlock(people, context, [&](std::size_t first, const SpectraBlock& block) {
        const auto at = static_cast<Index>(first);
        result.targets.middleRows(at, block.rows()) = (block.rowwise() - mean) * components;
        const MatrixXd exact = (block * rows).cast<double>();
        for (Index i = 0; i < block.rows(); ++i) {
          Eigen::RowVectorXd seen = exact.row(i);
          photograph(options.noise, options.people.seed, first + static_cast<std::size_t>(i), seen);
          result.logInputs.row(at + i) =
              channels.inputs(seen).array().max(kSmallestNetworkChannel).log();
        }
      }));
  return result;
}

// Leads to uncorrelated inputs of mean 0 and variance 1; directions without variance stay small.
DenseLayer whitening(const MatrixXd& logInputs) {
  const Eigen::RowVectorXd mean = logInputs.colwise().mean();
  const MatrixXd centred = logInputs.rowwise() - mean;
  const MatrixXd covariance = centred.transpose() * centred / static_cast<double>(logInputs.rows());
  const SymmetricEigen eigen = symmetricEigen(covariance);
  const VectorXd scale =
      (eigen.values.array().max(0.0) + kLeastDeviation * kLeastDeviation).rsqrt();
  const MatrixXd matrix = scale.asDiagonal() * eigen.vectors.transpose();
  return linearLayer(matrix, -matrix * mean.transpose());
}

TrainingSet examplesOf(const Photographs& photographs, const DenseLayer& white) {
  TrainingSet set;
  set.inputs = white.outputs;
  set.outputs = static_cast<int>(photographs.targets.cols());
  set.targetWeights.assign(static_cast<std::size_t>(set.outputs), 1.0f / kSampleCount);
  const SampleMatrix<double> inputs =
      evaluate<double>({{white}}, photographs.logInputs.transpose());
  set.inputRows.resize(static_cast<std::size_t>(inputs.size()));
  set.targetRows.resize(static_cast<std::size_t>(photographs.targets.size()));
  Eigen::Map<Eigen::MatrixXf>(set.inputRows.data(), inputs.rows(), inputs.cols()) =
      inputs.cast<float>();
  Eigen::Map<Eigen::MatrixXf>(set.targetRows.data(), photographs.targets.cols(),
                              photographs.targets.rows()) = photographs.targets.transpose();
  return set;
}

DenseNetwork freshChromophoreNetwork(int inputs, const ChromophoreNetworkOptions& options) {
  std::vector<int> sizes = {inputs};
  sizes.insert(sizes.end(), options.hidden.begin(), options.hidden.end());
  sizes.push_back(kParameterCount);
  return randomNetwork(sizes, options.activation, Activation::sigmoid, options.trainer.seed);
}

// Whether the last layers are those that do not change. A best network that is not there yet has
// none.
bool endsIn(const DenseNetwork& network, const DenseNetwork& end) {
  return network.layers.empty() ||
         (network.layers.size() >= end.layers.size() &&
          std::equal(end.layers.rbegin(), end.layers.rend(), network.layers.rbegin()));
}

Status checkArguments(const SkinModel& model, const NetworkChannels& channels,
                      const SpectraNetwork& spectra, const ChromophoreNetworkOptions& options) {
  const std::string place = "ChromNN";
  CUTIS_CHECK(
      validateTraining(options.hidden, options.activation, options.people, options.trainer, place));
  CUTIS_CHECK(validate(spectra, place));
  if (!alike(spectra.profile, signatureOf(model.profile()))) {
    return inputError(place, "the SpectraNN was trained for another profile; train it again");
  }
  if (channels.inputCount() < 1 || channels.inputCount() > kMaximumUnits) {
    return inputError(place, "a network takes 1 to " + std::to_string(kMaximumUnits) +
                                 " channels, not " + std::to_string(channels.inputCount()));
  }
  if (channels.combination.size() > 0 && channels.combination.cols() != channels.rows.rows()) {
    return inputError(place, "the combination of channels does not fit the channels");
  }
  if (channels.names.size() != static_cast<std::size_t>(channels.inputCount())) {
    return inputError(place, "the number of input names differs from that of the inputs");
  }
  return {};
}

}  // namespace

Status validate(const ChromophoreNetwork& network, const std::string& place) {
  CUTIS_CHECK(validate(network.network, place));
  CUTIS_CHECK(validateAxes(network.axes, place));
  if (network.network.outputs() != kParameterCount ||
      network.network.layers.back().activation != Activation::sigmoid) {
    return inputError(place, "the network does not end in a sigmoid for each of five parameters");
  }
  if (network.inputs.size() != static_cast<std::size_t>(network.network.inputs())) {
    return inputError(place, "the network does not have as many inputs as it has channels");
  }
  return {};
}

ChromophoreNetworkOptions paperChromophoreNetworkOptions() {
  ChromophoreNetworkOptions options;
  options.hidden = {64, 64, 64};
  options.activation = Activation::sigmoid;
  options.noise = {0.0, 0.0};
  options.trainer = {};
  return options;
}

Result<ChromophoreNetwork> trainChromophoreNetwork(const SkinModel& model,
                                                   const NetworkChannels& channels,
                                                   const SpectraNetwork& spectra,
                                                   const ChromophoreNetworkOptions& options,
                                                   TrainingState& state, const JobContext& context,
                                                   const EpochCallback& onEpoch) {
  CUTIS_CHECK(checkArguments(model, channels, spectra, options));
  const DenseNetwork judge = merged(spectra.network);  // stays as it is while ChromNN learns
  CUTIS_TRY(photographs,
            takePhotographs(model, channels, spectra, options, context.child(0.0, 0.1)));
  const DenseLayer white = whitening(photographs.logInputs);
  const TrainingSet set = examplesOf(photographs, white);
  const std::size_t trained = options.hidden.size() + 1;
  CUTIS_CHECK(beginTraining(joined(freshChromophoreNetwork(channels.inputCount(), options), judge),
                            "ChromNN", state));
  if (!endsIn(state.network, judge) || !endsIn(state.best, judge)) {
    return inputError("ChromNN",
                      "the state of training belongs to another SpectraNN; start again without it");
  }
  CUTIS_CHECK(
      trainNetwork(set, {0, trained}, options.trainer, state, context.child(0.1, 1.0), onEpoch));

  ChromophoreNetwork result;
  result.profile = spectra.profile;
  result.channels = signatureOf(channels);
  result.inputs = channels.names;
  result.axes = model.profile().axes;
  DenseNetwork network;
  network.layers.push_back(white);
  network.layers.insert(network.layers.end(), state.best.layers.begin(),
                        state.best.layers.begin() + static_cast<std::ptrdiff_t>(trained));
  result.network = merged(network);
  return result;
}

}  // namespace cutis
