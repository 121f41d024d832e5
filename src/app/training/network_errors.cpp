#include "src/app/training/network_errors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/fit/network_solver.h"
#include "core/fit/population.h"
#include "core/neural/network_pipeline.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;

constexpr int kJudges = 4096;
constexpr Index kJudgesPerPiece = 64;
constexpr std::uint64_t kJudgeSeed = 2024;  // none that people to train on are drawn with
constexpr std::uint64_t kNoiseSeed = 2025;

JobContext withoutProgress(const JobContext& context) {
  return {context.stop, {}, context.notice};
}

// Rows that pick the visible samples of a spectrum.
SpectrumRows visibleRows() {
  SpectrumRows rows = SpectrumRows::Zero(kVisibleBand.count(), kSampleCount);
  for (Index i = 0; i < rows.rows(); ++i)
    rows(i, kVisibleBand.first + i) = 1.0;
  return rows;
}

// People, one a row, with their exact spectra.
struct Judges {
  MatrixXf parameters = MatrixXf(kJudges, kParameterCount);
  MatrixXd spectra = MatrixXd(kJudges, kSampleCount);
};

// Calls work(person) for all of them, in pieces.
Status forEachJudge(const JobContext& context, const std::function<void(Index)>& work) {
  constexpr Index kPieces = (kJudges + kJudgesPerPiece - 1) / kJudgesPerPiece;
  return parallelFor(static_cast<std::size_t>(kPieces), context, [&](std::size_t piece) -> Status {
    const Index first = static_cast<Index>(piece) * kJudgesPerPiece;
    for (Index i = first; i < std::min<Index>(kJudges, first + kJudgesPerPiece); ++i)
      work(i);
    return {};
  });
}

Result<Judges> drawJudges(const SkinModel& model, const JobContext& context) {
  const auto people = drawPopulation(protocolPopulation(), kJudges, kJudgeSeed);
  Judges judges;
  CUTIS_CHECK(forEachJudge(context, [&](Index i) {
    const ParameterVector& person = people[static_cast<std::size_t>(i)];
    judges.parameters.row(i) = person.matrix().transpose().cast<float>();
    judges.spectra.row(i) = model.reflectance(person).matrix().transpose();
  }));
  return judges;
}

MatrixXf run(const NetworkPipeline& pipeline, const MatrixXf& in, bool wantsParameters) {
  const auto count = static_cast<std::size_t>(in.rows());
  const auto inputs = packedRows(in.data(), static_cast<std::size_t>(in.cols()), count);
  MatrixXf out(in.rows(), wantsParameters ? Index{kParameterCount} : Index{pipeline.outputCount()});
  const auto outputs = packedRows(out.data(), static_cast<std::size_t>(out.cols()), count);
  if (wantsParameters) {
    pipeline.run(inputs, outputs, {});
  } else {
    pipeline.run(inputs, {}, outputs);
  }
  return out;
}

double errorOf(const MatrixXf& visible, const Judges& judges) {
  return (visible.cast<double>() -
          judges.spectra.middleCols(kVisibleBand.first, kVisibleBand.count()))
             .squaredNorm() /
         static_cast<double>(visible.size());
}

// The error of exact spectra of estimated parameters.
Result<double> errorOfParameters(const SkinModel& model, const MatrixXf& parameters,
                                 const Judges& judges, const JobContext& context) {
  MatrixXf visible(kJudges, kVisibleBand.count());
  CUTIS_CHECK(forEachJudge(context, [&](Index i) {
    const ParameterVector person = parameters.row(i).cast<double>().transpose().array();
    const Spectrum spectrum = model.reflectance(person);
    visible.row(i) = spectrum.segment(kVisibleBand.first, kVisibleBand.count())
                         .matrix()
                         .transpose()
                         .cast<float>();
  }));
  return errorOf(visible, judges);
}

// What the network is given, from photographs with noise.
MatrixXf inputsOf(const NetworkChannels& taken, const Judges& judges, const NoiseModel& noise) {
  MatrixXd channels = judges.spectra * taken.rows.matrix().transpose();
  for (Index i = 0; i < channels.rows(); ++i) {
    Random random(kNoiseSeed, static_cast<std::uint64_t>(i));
    for (Index k = 0; k < channels.cols(); ++k) {
      const double deviation = std::hypot(noise.read, noise.proportional * channels(i, k));
      channels(i, k) = std::max(0.0, channels(i, k) + deviation * random.normal());
    }
  }
  return taken.inputs(channels).cast<float>();
}

}  // namespace

Result<NetworkErrors> measureNetworks(const SkinModel& model, const Rig& rig,
                                      const NetworkFile& file, const JobContext& context) {
  CUTIS_TRY(channels, matchNetwork(file.chromophores, model.profile(), rig, "the networks"));
  CUTIS_TRY(judges, drawJudges(model, withoutProgress(context)));
  const SpectrumRows rows = visibleRows();
  const auto encoder = NetworkPipeline::encoder(file.chromophores);
  const auto decoder = NetworkPipeline::decoder(file.spectra, rows);
  CUTIS_TRY(both, NetworkPipeline::encoderDecoder(file.chromophores, file.spectra, rows));
  const MatrixXf clean = inputsOf(channels, judges, {0.0, 0.0});
  const MatrixXf noisy = inputsOf(channels, judges, rig.noise);
  CUTIS_TRY(encoded,
            errorOfParameters(model, run(encoder, clean, true), judges, withoutProgress(context)));
  CUTIS_TRY(encodedNoisy,
            errorOfParameters(model, run(encoder, noisy, true), judges, withoutProgress(context)));
  return NetworkErrors{errorOf(run(decoder, judges.parameters, false), judges), encoded,
                       errorOf(run(both, clean, false), judges), encodedNoisy,
                       errorOf(run(both, noisy, false), judges)};
}

}  // namespace cutis
