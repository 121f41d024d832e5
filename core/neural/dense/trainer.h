#pragma once

// Training of a dense network: mini-batches, mean squared error, Adam (Kingma & Ba 2015).
//
// Deterministic: the same set, options and seed give the same bytes for any number of threads, and
// also where training was cancelled and taken up again (on one instruction set). A mini-batch is
// split into fixed pieces whose gradients are added in a fixed order.

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/neural/dense/back_propagation.h"
#include "core/neural/dense/dense_network.h"

namespace cutis {

// Samples to learn from, one after the other.
struct TrainingSet {
  int inputs = 0;
  int outputs = 0;
  std::vector<float> inputRows;   // [sample][input]
  std::vector<float> targetRows;  // [sample][output]
  // error = mean over samples of Σ_outputs targetWeights · (output − target)²
  std::vector<float> targetWeights;

  std::size_t count() const {
    return inputs > 0 ? inputRows.size() / static_cast<std::size_t>(inputs) : 0;
  }
};

// The defaults of rate and weight decay are the paper's (§6.1).
struct TrainerOptions {
  double rate = 3e-4;         // the largest learning rate, in (0, 1]
  double weightDecay = 1e-6;  // share by which a weight shrinks per unit of rate, apart from the
                              // error (Loshchilov & Hutter 2019), so that it has no unit; [0, 1]
  double warmUp = 0.02;       // share of all steps over which the rate rises; [0, 1). It then falls
                              // to zero as a cosine
  int epochs = 40;            // times through the set, 1 to 100,000
  int batch = 384;            // samples of a step, 96 to 65,536; rounded down to whole pieces of 96
  double heldOutShare = 0.04;  // last part of the set: never trained on, [0, 0.5]
  int patience = 0;            // epochs without a smaller held-out error after which it stops;
                               // 0: never
  std::uint64_t seed = 1;      // of the order of the samples

  bool operator==(const TrainerOptions&) const = default;
};

Status validate(const TrainerOptions& options, const std::string& place);

struct TrainingEpoch {
  int epoch = 0;              // the first is 1
  double rate = 0.0;          // at its end
  double trainedError = 0.0;  // mean over the epoch, while the weights changed
  double heldOutError = 0.0;  // at its end; of the training itself where nothing is held out

  bool operator==(const TrainingEpoch&) const = default;
};

// All that is needed to go on after any whole epoch. A fresh one has just the network.
struct TrainingState {
  DenseNetwork network;
  std::vector<float> firstMoment;  // of Adam, one per trained weight
  std::vector<float> secondMoment;
  std::int64_t steps = 0;
  std::vector<TrainingEpoch> curve;  // of the epochs done
  DenseNetwork best;                 // after the epoch with the smallest held-out error
  double bestError = std::numeric_limits<double>::infinity();
  int bestEpoch = 0;

  bool operator==(const TrainingState&) const = default;
};

// Called after each epoch, from the thread that trains.
using EpochCallback = std::function<void(const TrainingEpoch&)>;

// Trains until the epochs are over or patience is at an end; the result is state.best. Cancelled:
// the state is that after the last whole epoch, and the same call goes on from there. Errors:
// options out of range, a set that does not fit the network or is smaller than a batch, a state
// that does not fit, an error that is no longer a finite number. Cost: about 3 multiply-adds per
// weight, sample and epoch, near the processor's peak.
Status trainNetwork(const TrainingSet& set, TrainedLayers trained, const TrainerOptions& options,
                    TrainingState& state, const JobContext& context,
                    const EpochCallback& onEpoch = {});

// Mean error of samples [first, last) of a set. Deterministic likewise.
Result<double> meanError(const DenseNetwork& network, const TrainingSet& set, std::size_t first,
                         std::size_t last, const JobContext& context);

}  // namespace cutis
