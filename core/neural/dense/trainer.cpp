#include "core/neural/dense/trainer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/neural/dense/adam.h"
#include "core/neural/dense/dense_kernel.h"

namespace cutis {
namespace {

// Samples that one thread takes at a time: enough to pay for handing them out, few enough that two
// threads share a small batch.
constexpr std::size_t kPiece = 2 * kSampleStep;

// Stops, but does not report: the trainer does.
JobContext quiet(const JobContext& context) {
  return {context.stop, {}, {}};
}

// Samples as the kernels want them, [unit][kPiece].
struct PieceBuffer {
  AlignedFloats inputs;
  AlignedFloats targets;
  PropagationScratch scratch;
  std::vector<float> gradient;
  double error = 0.0;
};

void gather(const std::vector<float>& rows, int units, const std::uint32_t* samples,
            std::size_t live, AlignedFloats& columns) {
  const auto width = static_cast<std::size_t>(units);
  columns.assign(width * kPiece, 0.0f);
  for (std::size_t i = 0; i < live; ++i) {
    const float* row = rows.data() + samples[i] * width;
    for (std::size_t k = 0; k < width; ++k)
      columns[k * kPiece + i] = row[k];
  }
}

SamplePiece fillPiece(const TrainingSet& set, const std::uint32_t* samples, std::size_t live,
                      PieceBuffer& buffer) {
  gather(set.inputRows, set.inputs, samples, live, buffer.inputs);
  gather(set.targetRows, set.outputs, samples, live, buffer.targets);
  const auto rows = [live](const AlignedFloats& of) {
    return PixelRows<const float>{of.data(), of.size() / kPiece, live, kPiece};
  };
  return {rows(buffer.inputs), rows(buffer.targets)};
}

class Trainer {
 public:
  Trainer(const TrainingSet& set, TrainedLayers trained, const TrainerOptions& options,
          const JobContext& context)
      : set_(set), trained_(trained), options_(options), context_(context) {
    const auto all = static_cast<double>(set.count());
    trainedCount_ = set.count() - static_cast<std::size_t>(all * options.heldOutShare);
    pieces_ = std::max(static_cast<std::size_t>(options.batch) / kPiece, std::size_t{1});
    stepsPerEpoch_ = trainedCount_ / (pieces_ * kPiece);
    buffers_.resize(pieces_);
  }

  std::size_t trainedCount() const { return trainedCount_; }
  std::size_t stepsPerEpoch() const { return stepsPerEpoch_; }

  // Changes the state only when the epoch is whole.
  Status runEpoch(TrainingState& state) {
    TrainingState next = state;
    const auto done = static_cast<int>(state.curve.size());
    const std::vector<std::uint32_t> order = shuffled(done);
    double sum = 0.0;
    for (std::size_t step = 0; step < stepsPerEpoch_; ++step) {
      CUTIS_TRY(error, runStep(order.data() + step * pieces_ * kPiece, next));
      sum += error;
      const double part = static_cast<double>(step + 1) / static_cast<double>(stepsPerEpoch_);
      if (step % 16 == 0) context_.progress.report((done + part) / options_.epochs);
    }
    TrainingEpoch epoch;
    epoch.epoch = done + 1;
    epoch.rate = rateAt(next.steps);
    epoch.trainedError = sum / static_cast<double>(stepsPerEpoch_ * pieces_ * kPiece);
    epoch.heldOutError = epoch.trainedError;
    if (trainedCount_ < set_.count()) {
      CUTIS_TRY(heldOut,
                meanError(next.network, set_, trainedCount_, set_.count(), quiet(context_)));
      epoch.heldOutError = heldOut;
    }
    if (!std::isfinite(epoch.trainedError + epoch.heldOutError)) return diverged(epoch.epoch);
    next.curve.push_back(epoch);
    if (epoch.heldOutError < next.bestError) {
      next.best = next.network;
      next.bestError = epoch.heldOutError;
      next.bestEpoch = epoch.epoch;
    }
    state = std::move(next);
    return {};
  }

 private:
  static Error diverged(int epoch) {
    return inputError("", "training diverged in epoch " + std::to_string(epoch) +
                              ": the error is no longer a number; use a smaller learning rate");
  }

  // A fresh order for each epoch, so that none depends on how often training was interrupted.
  std::vector<std::uint32_t> shuffled(int epoch) const {
    std::vector<std::uint32_t> order(trainedCount_);
    std::iota(order.begin(), order.end(), 0u);
    Random random(options_.seed, static_cast<std::uint64_t>(epoch));
    for (std::size_t i = order.size() - 1; i > 0; --i) {
      std::swap(order[i], order[random.bits() % (i + 1)]);
    }
    return order;
  }

  double rateAt(std::int64_t step) const {
    const double all = static_cast<double>(stepsPerEpoch_) * options_.epochs;
    const double done = static_cast<double>(step) / all;
    if (done < options_.warmUp) return options_.rate * done / options_.warmUp;
    const double turn = (done - options_.warmUp) / (1.0 - options_.warmUp);
    return 0.5 * options_.rate * (1.0 + std::cos(std::numbers::pi * std::min(turn, 1.0)));
  }

  // Returns the sum of the samples' errors.
  Result<double> runStep(const std::uint32_t* samples, TrainingState& state) {
    const BackPropagation propagation(state.network, set_.targetWeights, trained_);
    CUTIS_CHECK(parallelFor(pieces_, quiet(context_), [&](std::size_t i) -> Status {
      PieceBuffer& buffer = buffers_[i];
      buffer.gradient.assign(propagation.gradientSize(), 0.0f);
      const SamplePiece piece = fillPiece(set_, samples + i * kPiece, kPiece, buffer);
      buffer.error = propagation.addGradient(piece, buffer.scratch, buffer.gradient.data());
      return {};
    }));
    std::vector<float>& gradient = buffers_.front().gradient;
    double error = buffers_.front().error;
    for (std::size_t i = 1; i < pieces_; ++i) {
      for (std::size_t k = 0; k < gradient.size(); ++k)
        gradient[k] += buffers_[i].gradient[k];
      error += buffers_[i].error;
    }
    const float share = 1.0f / static_cast<float>(pieces_ * kPiece);
    for (float& g : gradient)
      g *= share;
    update(gradient, state);
    return error;
  }

  void update(const std::vector<float>& gradient, TrainingState& state) const {
    ++state.steps;
    const AdamStep step = {state.steps, rateAt(state.steps), options_.weightDecay};
    std::size_t at = 0;
    const auto adjust = [&](std::vector<float>& weights) {
      adamUpdate(step, gradient.data() + at, weights.size(), state.firstMoment.data() + at,
                 state.secondMoment.data() + at, weights.data());
      at += weights.size();
    };
    const std::size_t last = std::min(trained_.last, state.network.layers.size());
    for (std::size_t i = trained_.first; i < last; ++i) {
      adjust(state.network.layers[i].weights);
      adjust(state.network.layers[i].bias);
    }
  }

  const TrainingSet& set_;
  TrainedLayers trained_;
  TrainerOptions options_;
  const JobContext& context_;
  std::size_t trainedCount_ = 0;
  std::size_t pieces_ = 1;
  std::size_t stepsPerEpoch_ = 0;
  std::vector<PieceBuffer> buffers_;
};

Status checkSet(const TrainingSet& set, const DenseNetwork& network) {
  CUTIS_CHECK(validate(network, "the network to train"));
  const bool fits = set.inputs == network.inputs() && set.outputs == network.outputs() &&
                    set.targetWeights.size() == static_cast<std::size_t>(set.outputs) &&
                    set.inputRows.size() == set.count() * static_cast<std::size_t>(set.inputs) &&
                    set.targetRows.size() == set.count() * static_cast<std::size_t>(set.outputs);
  if (!fits) return inputError("", "the training set does not fit the network");
  return {};
}

// Whether such a training could have left the state behind after a whole epoch.
bool couldBe(const TrainingState& state, std::size_t weights, std::size_t stepsPerEpoch,
             int epochs) {
  const std::size_t done = state.curve.size();
  return state.firstMoment.size() == weights && state.secondMoment.size() == weights &&
         done <= static_cast<std::size_t>(epochs) &&
         state.steps == static_cast<std::int64_t>(done * stepsPerEpoch) && state.bestEpoch >= 1 &&
         state.bestEpoch <= static_cast<int>(done) && sameShape(state.best, state.network);
}

// Fills in what a fresh state does not have.
Status prepareState(std::size_t weights, std::size_t stepsPerEpoch, int epochs,
                    TrainingState& state) {
  if (state.steps == 0 && state.curve.empty()) {
    state.firstMoment.assign(weights, 0.0f);
    state.secondMoment.assign(weights, 0.0f);
    state.best = state.network;
    return {};
  }
  if (couldBe(state, weights, stepsPerEpoch, epochs))
    return validate(state.best, "the state of training");
  return inputError(
      "", "the state of training does not fit the network and its options; start again without it");
}

bool outOfPatience(const TrainerOptions& options, const TrainingState& state) {
  return options.patience > 0 &&
         static_cast<int>(state.curve.size()) - state.bestEpoch >= options.patience;
}

Status checkOption(bool good, const std::string& place, const char* message) {
  if (good) return {};
  return inputError(place, message);
}

}  // namespace

Status validate(const TrainerOptions& o, const std::string& place) {
  CUTIS_CHECK(checkOption(o.rate > 0.0 && o.rate <= 1.0, place,
                          "the learning rate must be above 0 and at most 1"));
  CUTIS_CHECK(checkOption(o.weightDecay >= 0.0 && o.weightDecay <= 1.0, place,
                          "the weight decay must be from 0 to 1"));
  CUTIS_CHECK(checkOption(o.warmUp >= 0.0 && o.warmUp < 1.0, place,
                          "the share of warm-up must be from 0 to below 1"));
  CUTIS_CHECK(checkOption(o.epochs >= 1 && o.epochs <= 100'000, place,
                          "the number of epochs must be from 1 to 100000"));
  CUTIS_CHECK(checkOption(o.batch >= 96 && o.batch <= 65'536, place,
                          "the size of a mini-batch must be from 96 to 65536"));
  CUTIS_CHECK(checkOption(o.heldOutShare >= 0.0 && o.heldOutShare <= 0.5, place,
                          "the share that is held out must be from 0 to 0.5"));
  return checkOption(o.patience >= 0, place, "patience must not be negative");
}

Status trainNetwork(const TrainingSet& set, TrainedLayers trained, const TrainerOptions& options,
                    TrainingState& state, const JobContext& context, const EpochCallback& onEpoch) {
  CUTIS_CHECK(validate(options, "training"));
  CUTIS_CHECK(checkSet(set, state.network));
  const BackPropagation propagation(state.network, set.targetWeights, trained);
  Trainer trainer(set, trained, options, context);
  if (trainer.stepsPerEpoch() == 0) {
    return inputError("", "there are " + std::to_string(trainer.trainedCount()) +
                              " samples to train on, fewer than a mini-batch of " +
                              std::to_string(options.batch));
  }
  CUTIS_CHECK(
      prepareState(propagation.gradientSize(), trainer.stepsPerEpoch(), options.epochs, state));
  while (static_cast<int>(state.curve.size()) < options.epochs && !outOfPatience(options, state)) {
    CUTIS_CHECK(trainer.runEpoch(state));
    if (onEpoch) onEpoch(state.curve.back());
  }
  context.progress.report(1.0);
  return {};
}

Result<double> meanError(const DenseNetwork& network, const TrainingSet& set, std::size_t first,
                         std::size_t last, const JobContext& context) {
  const BackPropagation propagation(network, set.targetWeights, {});
  const std::size_t pieces = (last - first + kPiece - 1) / kPiece;
  std::vector<double> errors(pieces);
  CUTIS_CHECK(parallelFor(pieces, context, [&](std::size_t p) -> Status {
    PieceBuffer buffer;
    const std::size_t begin = first + p * kPiece;
    std::vector<std::uint32_t> samples(std::min(kPiece, last - begin));
    std::iota(samples.begin(), samples.end(), static_cast<std::uint32_t>(begin));
    const SamplePiece piece = fillPiece(set, samples.data(), samples.size(), buffer);
    errors[p] = propagation.error(piece, buffer.scratch);
    return {};
  }));
  const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
  return sum / static_cast<double>(std::max(last - first, std::size_t{1}));
}

}  // namespace cutis
