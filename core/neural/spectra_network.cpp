#include "core/neural/spectra_network.h"

#include <algorithm>
#include <cmath>

#include "core/neural/spectra_batch.h"
#include "core/neural/training_options.h"
#include "core/skin/profile/profile_signature.h"

namespace cutis {
namespace {

using Eigen::Index;

// Coordinates, evenly spread over [0, 1], to mean 0 and variance 1.
const double kCoordinateScale = std::sqrt(12.0);

int componentCount(const SpectraBasis& basis, const SpectraNetworkOptions& options) {
  return options.components > 0 ? options.components : basis.componentsFor(options.truncationError);
}

// Deviations of the weights over the table: the unit in which the network learns them.
Eigen::VectorXd weightUnits(const SpectraBasis& basis, int components) {
  return basis.variances.head(components).cwiseMax(1e-20).cwiseSqrt();
}

Result<TrainingSet> sampledSet(const SkinModel& model, const SpectraBasis& basis, int components,
                               const SpectraNetworkOptions& options, const JobContext& context) {
  const ParameterAxes& axes = model.profile().axes;
  const std::vector<ParameterVector> people = drawTrainingPeople(options.people, axes);
  const Eigen::VectorXd units = weightUnits(basis, components);
  const Eigen::MatrixXf projection =
      (basis.components.leftCols(components) * units.cwiseInverse().asDiagonal()).cast<float>();
  const Eigen::RowVectorXf mean = basis.mean.matrix().transpose().cast<float>();
  TrainingSet set;
  set.inputs = kParameterCount;
  set.outputs = components;
  set.inputRows.resize(people.size() * std::size_t{kParameterCount});
  set.targetRows.resize(people.size() * static_cast<std::size_t>(components));
  for (Index j = 0; j < components; ++j) {
    set.targetWeights.push_back(static_cast<float>(units[j] * units[j] / kSampleCount));
  }
  const SpectraSource source(model);
  CUTIS_CHECK(
      source.forEachBlock(people, context, [&](std::size_t first, const SpectraBlock& block) {
        const Eigen::MatrixXf weights = (block.rowwise() - mean) * projection;
        for (Index i = 0; i < block.rows(); ++i) {
          const std::size_t person = first + static_cast<std::size_t>(i);
          for (std::size_t k = 0; k < axes.size(); ++k) {
            const double at = networkCoordinate(axes[k], people[person][static_cast<Index>(k)]);
            set.inputRows[person * axes.size() + k] =
                static_cast<float>(kCoordinateScale * (at - 0.5));
          }
          for (Index j = 0; j < components; ++j) {
            set.targetRows[person * static_cast<std::size_t>(components) +
                           static_cast<std::size_t>(j)] = weights(i, j);
          }
        }
      }));
  return set;
}

DenseNetwork freshSpectraNetwork(int components, const SpectraNetworkOptions& options) {
  std::vector<int> sizes = {kParameterCount};
  sizes.insert(sizes.end(), options.hidden.begin(), options.hidden.end());
  sizes.push_back(components);
  return randomNetwork(sizes, options.activation, Activation::linear, options.trainer.seed);
}

// The network with the scalings around it.
DenseNetwork complete(const DenseNetwork& trained, const Eigen::VectorXd& units) {
  const Eigen::MatrixXd scale =
      kCoordinateScale * Eigen::MatrixXd::Identity(kParameterCount, kParameterCount);
  DenseNetwork network;
  network.layers.push_back(
      linearLayer(scale, Eigen::VectorXd::Constant(kParameterCount, -0.5 * kCoordinateScale)));
  network = joined(network, trained);
  network.layers.push_back(linearLayer(units.asDiagonal(), Eigen::VectorXd::Zero(units.size())));
  return merged(network);
}

}  // namespace

Status validate(const SpectraNetwork& network, const std::string& place) {
  CUTIS_CHECK(validate(network.network, place));
  CUTIS_CHECK(validateAxes(network.axes, place));
  if (network.network.inputs() != kParameterCount || network.components.rows() != kSampleCount ||
      network.components.cols() != network.network.outputs()) {
    return inputError(place,
                      "the network does not lead from five parameters to the weights of its "
                      "components");
  }
  // Components are of length 1, and a mean of reflectances lies between 0 and 1.
  constexpr double kLargest = 1.01;
  const bool sound = (network.components.array().abs() <= kLargest).all() &&
                     (network.mean.abs() <= kLargest).all();
  if (!sound) {
    return inputError(place,
                      "the mean or the components have a value that none of spectra has; train the "
                      "network anew");
  }
  return {};
}

SpectraNetworkOptions paperSpectraNetworkOptions() {
  SpectraNetworkOptions options;
  options.hidden = {64, 64, 64};
  options.activation = Activation::relu;
  options.components = 10;
  options.trainer = {};
  return options;
}

Result<SpectraNetwork> trainSpectraNetwork(const SkinModel& model, const SpectraBasis& basis,
                                           const SpectraNetworkOptions& options,
                                           TrainingState& state, const JobContext& context,
                                           const EpochCallback& onEpoch) {
  CUTIS_CHECK(validateTraining(options.hidden, options.activation, options.people, options.trainer,
                               "SpectraNN"));
  const int components = componentCount(basis, options);
  if (components < 1 || components > kMaximumComponents) {
    return inputError("SpectraNN", "the number of components must be from 1 to " +
                                       std::to_string(kMaximumComponents));
  }
  CUTIS_TRY(set, sampledSet(model, basis, components, options, context.child(0.0, 0.1)));
  CUTIS_CHECK(beginTraining(freshSpectraNetwork(components, options), "SpectraNN", state));
  CUTIS_CHECK(trainNetwork(set, {}, options.trainer, state, context.child(0.1, 1.0), onEpoch));

  SpectraNetwork result;
  result.profile = signatureOf(model.profile());
  result.axes = model.profile().axes;
  result.mean = basis.mean;
  result.components = basis.components.leftCols(components);
  result.network = complete(state.best, weightUnits(basis, components));
  return result;
}

}  // namespace cutis
