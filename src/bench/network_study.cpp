#include "src/bench/network_study.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "core/base/parallel.h"
#include "core/evaluate/error_protocol.h"
#include "core/neural/dense/aligned_floats.h"
#include "core/neural/network_channels.h"
#include "core/neural/network_pipeline.h"
#include "core/skin/profile/profile_signature.h"
#include "src/app/training/network_training.h"
#include "src/files/networks/network_file.h"

namespace cutis {
namespace {

using Eigen::Index;

constexpr std::uint64_t kNetworkNoiseSeed = 2;
constexpr char kWhite[] = "white";
// People whose spectra are held at once.
constexpr std::size_t kPiece = 128;
// Pixels of a picture that a thread takes at once: in and out stay in the second cache.
constexpr std::size_t kNetworkBatch = 4096;
constexpr int kRuns = 5;

// Networks, and which channels of which rig they take.
struct RiggedNetworks {
  Rig rig;
  NetworkChannels channels;
  NetworkFile file;
};

Result<std::optional<NetworkFile>> builtInFor(const Profile& profile,
                                              const NetworkChannels& channels) {
  const Signature wantedProfile = signatureOf(profile), wantedChannels = signatureOf(channels);
  for (const std::string& name : builtInNetworkNames()) {
    CUTIS_TRY(file, builtInNetworks(name));
    if (alike(file.chromophores.profile, wantedProfile) &&
        alike(file.chromophores.channels, wantedChannels))
      return std::optional(std::move(file));
  }
  return std::optional<NetworkFile>();
}

// What the networks take of photographed channels, both [plane][count].
std::vector<float> inputsOf(const NetworkChannels& channels, const std::vector<float>& photographed,
                            std::size_t count) {
  const Eigen::Map<const Eigen::MatrixXf> planes(photographed.data(), static_cast<Index>(count),
                                                 channels.rows.rows());
  const Eigen::MatrixXf inputs = channels.inputs(planes.cast<double>()).cast<float>();
  return {inputs.data(), inputs.data() + inputs.size()};
}

// All pixels through a pipeline, on all cores. inputs, parameters, outputs: [plane][count]; the
// last two may be null.
Status runPipeline(const NetworkPipeline& pipeline, std::size_t count, const float* inputs,
                   float* parameters, float* outputs, const JobContext& context) {
  const auto in = packedRows(inputs, static_cast<std::size_t>(pipeline.inputCount()), count);
  const auto middle = packedRows(parameters, kParameterCount, count);
  const auto out = packedRows(outputs, static_cast<std::size_t>(pipeline.outputCount()), count);
  const std::size_t pieces = (count + kNetworkBatch - 1) / kNetworkBatch;
  return parallelFor(pieces, context, [&](std::size_t piece) -> Status {
    const std::size_t first = piece * kNetworkBatch, size = std::min(kNetworkBatch, count - first);
    pipeline.run(in.part(first, size),
                 parameters != nullptr ? middle.part(first, size) : PixelRows<float>{},
                 outputs != nullptr ? out.part(first, size) : PixelRows<float>{});
    return {};
  });
}

// Rows that pick every sample of the grid.
SpectrumRows wholeSpectra() {
  return Eigen::MatrixXd::Identity(kSampleCount, kSampleCount).array();
}

// Mean squared errors of whole spectra, [sample][person], by band.
Result<BandErrors> errorsOfSpectra(const SkinModel& model,
                                   const std::vector<ParameterVector>& people,
                                   const std::vector<float>& spectra, const JobContext& context) {
  const FullSpectra exact(model);
  const std::size_t count = people.size();
  std::vector<BandErrors> pieces((count + kPiece - 1) / kPiece);
  CUTIS_CHECK(parallelFor(pieces.size(), context, [&](std::size_t piece) -> Status {
    const std::size_t first = piece * kPiece, here = std::min(kPiece, count - first);
    std::vector<double> truth;
    exact.evaluate(std::span(people).subspan(first, here), truth);
    const auto meanSquare = [&](const Band& band) {
      double sum = 0.0;
      for (int sample = band.first; sample <= band.last; ++sample) {
        const auto s = static_cast<std::size_t>(sample);
        for (std::size_t i = 0; i < here; ++i) {
          const double away = double{spectra[s * count + first + i]} - truth[s * here + i];
          sum += away * away;
        }
      }
      return sum / (static_cast<double>(band.count()) * static_cast<double>(count));
    };
    pieces[piece] = {meanSquare(kVisibleBand), meanSquare(kUltravioletBand),
                     meanSquare(kNearInfraredBand)};
    return {};
  }));
  BandErrors errors;
  for (const BandErrors& piece : pieces) {
    errors.visible += piece.visible;
    errors.ultraviolet += piece.ultraviolet;
    errors.nearInfrared += piece.nearInfrared;
  }
  return errors;
}

Status measureDecoder(const BenchSubject& subject, const SpectraNetwork& spectra,
                      const JobContext& context, NetworkFigures& figures) {
  const auto people = benchPeople(subject.pixels);
  std::vector<float> parameters(kParameterCount * people.size());
  for (std::size_t i = 0; i < people.size(); ++i) {
    for (std::size_t k = 0; k < kParameterCount; ++k)
      parameters[k * people.size() + i] = static_cast<float>(people[i][static_cast<Index>(k)]);
  }
  std::vector<float> decoded(kSampleCount * people.size());
  CUTIS_CHECK(runPipeline(NetworkPipeline::decoder(spectra, wholeSpectra()), people.size(),
                          parameters.data(), nullptr, decoded.data(), context));
  CUTIS_TRY(errors, errorsOfSpectra(*subject.model, people, decoded, context));
  figures.decoded = errors;
  return {};
}

Status measureNoises(const BenchSubject& subject, const RiggedNetworks& networks,
                     const JobContext& context, NetworkFigures& figures) {
  CUTIS_TRY(both, NetworkPipeline::encoderDecoder(networks.file.chromophores, networks.file.spectra,
                                                  wholeSpectra()));
  CUTIS_TRY(pixels, ProtocolPixels::create(*subject.model, networks.rig,
                                           benchPeople(subject.pixels), context));
  std::vector<float> parameters(kParameterCount * pixels.count());
  std::vector<float> spectra(kSampleCount * pixels.count());
  for (const double noise : kBenchNoises) {
    const auto inputs =
        inputsOf(networks.channels, pixels.photograph(noise, kNetworkNoiseSeed), pixels.count());
    CUTIS_CHECK(runPipeline(both, pixels.count(), inputs.data(), parameters.data(), spectra.data(),
                            context));
    CUTIS_TRY(encoded, subject.meter->measure(pixels.people(), parameters, context));
    CUTIS_TRY(decoded, errorsOfSpectra(*subject.model, pixels.people(), spectra, context));
    figures.errors.push_back({noise, summarise(encoded).visibleMse, decoded.visible});
  }
  return {};
}

// Seconds for all pixels, the fastest of several runs.
Result<double> secondsOf(const NetworkPipeline& pipeline, std::size_t count,
                         const AlignedFloats& inputs, AlignedFloats& parameters,
                         AlignedFloats* outputs, const JobContext& context) {
  using Clock = std::chrono::steady_clock;
  double fastest = std::numeric_limits<double>::infinity();
  for (int run = 0; run < kRuns; ++run) {
    const auto start = Clock::now();
    CUTIS_CHECK(runPipeline(pipeline, count, inputs.data(), parameters.data(),
                            outputs != nullptr ? outputs->data() : nullptr, context));
    fastest = std::min(fastest, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return fastest;
}

// A picture's inputs, people of the protocol over and over: networks take equally long for all.
Result<AlignedFloats> pictureInputs(const BenchSubject& subject, const RiggedNetworks& networks,
                                    std::size_t count, const JobContext& context) {
  CUTIS_TRY(pixels, ProtocolPixels::create(*subject.model, networks.rig,
                                           benchPeople(subject.pixels), context));
  const auto known = inputsOf(networks.channels, pixels.photograph(kUsualNoise, kNetworkNoiseSeed),
                              pixels.count());
  const std::size_t planes = known.size() / pixels.count();
  AlignedFloats inputs(planes * count);
  for (std::size_t k = 0; k < planes; ++k) {
    for (std::size_t i = 0; i < count; ++i)
      inputs[k * count + i] = known[k * pixels.count() + i % pixels.count()];
  }
  return inputs;
}

Status timePicture(const BenchSubject& subject, const RiggedNetworks& networks, int size,
                   const JobContext& context, NetworkFigures& figures) {
  const SpectrumRows rows = responseRows(networks.rig);
  const auto encoder = NetworkPipeline::encoder(networks.file.chromophores);
  CUTIS_TRY(both, NetworkPipeline::encoderDecoder(networks.file.chromophores, networks.file.spectra,
                                                  rows));
  const std::size_t count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  CUTIS_TRY(inputs, pictureInputs(subject, networks, count, context));
  AlignedFloats parameters(kParameterCount * count);
  AlignedFloats outputs(static_cast<std::size_t>(rows.rows()) * count);
  CUTIS_TRY(encode, secondsOf(encoder, count, inputs, parameters, nullptr, context));
  CUTIS_TRY(encodeAndDecode, secondsOf(both, count, inputs, parameters, &outputs, context));
  figures.size = size;
  figures.encodeSeconds = encode;
  figures.bothSeconds = encodeAndDecode;
  figures.workPerPixel = both.workPerPixel();
  return {};
}

Result<NetworkFigures> measureAll(const BenchSubject& subject, const RiggedNetworks& networks,
                                  int size, const JobContext& context) {
  NetworkFigures figures;
  figures.lights = static_cast<int>(networks.rig.lights.size());
  figures.channels = networks.file.chromophores.network.inputs();
  figures.weights = networks.file.chromophores.network.parameterCount() +
                    networks.file.spectra.network.parameterCount();
  CUTIS_CHECK(measureDecoder(subject, networks.file.spectra, context, figures));
  CUTIS_CHECK(measureNoises(subject, networks, context, figures));
  CUTIS_CHECK(timePicture(subject, networks, size, context, figures));
  return figures;
}

Result<NetworkFile> train(const BenchSubject& subject, const JobContext& context,
                          BenchFigures& figures) {
  NetworkTraining training;
  training.chromophores.noise = subject.rig.noise;
  NetworkTrainingState state;
  CUTIS_TRY(trained, trainNetworks(*subject.model, subject.rig, training, state, context));
  figures.trainingSeconds = trained.seconds;
  return std::move(trained.file);
}

// Adds those that are built in for these channels, if there are any.
Status addBuiltIn(const BenchSubject& subject, const Rig& rig, const NetworkChannels& channels,
                  std::vector<RiggedNetworks>& all) {
  CUTIS_TRY(known, builtInFor(subject.model->profile(), channels));
  if (known) all.push_back({rig, channels, std::move(*known)});
  return {};
}

}  // namespace

Status runNetworks(const BenchSubject& subject, const NetworkSeries& series, MethodSolvers& solvers,
                   const JobContext& context, BenchFigures& figures) {
  const JobContext silent = {context.stop, {}, {}};
  std::vector<RiggedNetworks> all;
  CUTIS_CHECK(addBuiltIn(subject, subject.rig, networkChannels(subject.rig), all));
  if (series.training) {
    CUTIS_TRY(trained, train(subject, context.child(0.0, 0.7), figures));
    if (all.empty()) all.push_back({subject.rig, networkChannels(subject.rig), std::move(trained)});
  }
  if (all.empty()) return {};
  solvers.setNetwork(std::make_shared<const ChromophoreNetwork>(all.front().file.chromophores));
  if (const auto paper = paperNetworkChannels(subject.rig, "--rig"))
    CUTIS_CHECK(addBuiltIn(subject, subject.rig, paper.value(), all));
  if (subject.rig.lights.size() > 1 && subject.rig.lightIndex(kWhite) >= 0) {
    CUTIS_TRY(white, withLights(subject.rig, {kWhite}, "--rig"));
    CUTIS_CHECK(addBuiltIn(subject, white, networkChannels(white), all));
  }
  for (const RiggedNetworks& networks : all) {
    CUTIS_TRY(measured, measureAll(subject, networks, series.size, silent));
    figures.networks.push_back(std::move(measured));
  }
  return {};
}

}  // namespace cutis
