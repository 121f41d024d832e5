#include "src/app/training/network_training.h"

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/content_hash.h"
#include "core/base/number_text.h"
#include "src/files/networks/network_parts.h"

namespace cutis {
namespace {

// Parts of the whole: components, SpectraNN, ChromNN.
constexpr double kComponentsEnd = 0.2;
constexpr double kSpectraEnd = 0.55;

// Stops, but does not report: the fractions of the trainer say nothing of the error, so progress is
// reported epoch by epoch.
JobContext silent(const JobContext& context) {
  return {context.stop, {}, context.notice};
}

// The error of reflectance, as everywhere the errors of networks are shown.
std::string percentText(double meanSquaredError) {
  return formatNumber(100.0 * std::sqrt(meanSquaredError), 2) + " %";
}

EpochCallback epochReport(NetworkKind kind, int epochs, const JobContext& context,
                          const NetworkObserver& observer) {
  return [=](const TrainingEpoch& epoch) {
    const std::string stage = std::string(networkName(kind)) + ", epoch " +
                              std::to_string(epoch.epoch) + " of " + std::to_string(epochs) +
                              ", error " + percentText(epoch.heldOutError);
    context.child(0.0, 1.0, stage).progress.report(static_cast<double>(epoch.epoch) / epochs);
    if (observer) observer({kind, epochs, epoch});
  };
}

Result<NetworkChannels> channelsFor(const NetworkTraining& training, const Rig& rig) {
  if (training.paperChannels) return paperNetworkChannels(rig, "");
  return networkChannels(rig);
}

// Networks as others will read them, so that what is measured is what is used.
Result<NetworkFile> asRead(const NetworkFile& file) {
  return parseNetworks(networkText(file), "the trained networks");
}

}  // namespace

NetworkTraining usualTraining(const Rig& rig, const std::string& profile) {
  NetworkTraining training;
  training.chromophores.noise = rig.noise;
  training.command = "train --rig " + rig.name + " --profile " + profile + " --lights ";
  for (const RigLight& light : rig.lights) {
    training.command += (&light == &rig.lights.front() ? "" : ",") + light.name;
  }
  training.command +=
      " --noise " + formatNumber(rig.noise.read) + "," + formatNumber(rig.noise.proportional);
  return training;
}

const char* networkName(NetworkKind kind) {
  return kind == NetworkKind::spectra ? "SpectraNN" : "ChromNN";
}

Result<std::string> trainingIdentity(const SkinModel& model, const Rig& rig,
                                     const NetworkTraining& training) {
  CUTIS_TRY(channels, channelsFor(training, rig));
  ContentHash hash;
  hash.add(optionsText(training.spectra)).add(optionsText(training.chromophores));
  hash.add(static_cast<double>(training.tableStep)).add(fingerprint(model.profile()));
  for (const float value : signatureOf(channels))
    hash.add(static_cast<double>(value));
  return hash.digest();
}

Result<TrainedNetworks> trainNetworks(const SkinModel& model, const Rig& rig,
                                      const NetworkTraining& training, NetworkTrainingState& state,
                                      const JobContext& context, const NetworkObserver& observer) {
  const auto start = std::chrono::steady_clock::now();
  CUTIS_TRY(channels, channelsFor(training, rig));
  CUTIS_TRY(basis,
            computeSpectraBasis(model, context.child(0.0, kComponentsEnd, "principal components"),
                                training.tableStep));
  CUTIS_TRY(spectra,
            trainSpectraNetwork(model, basis, training.spectra, state.spectra, silent(context),
                                epochReport(NetworkKind::spectra, training.spectra.trainer.epochs,
                                            context.child(kComponentsEnd, kSpectraEnd), observer)));
  CUTIS_TRY(
      chromophores,
      trainChromophoreNetwork(
          model, channels, spectra, training.chromophores, state.chromophores, silent(context),
          epochReport(NetworkKind::chromophores, training.chromophores.trainer.epochs,
                      context.child(kSpectraEnd, 1.0), observer)));
  CUTIS_TRY(file, asRead({rig.name, model.profile().name, training.command, training.spectra,
                          training.chromophores, std::move(spectra), std::move(chromophores)}));
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return TrainedNetworks{std::move(file), std::move(basis), state.spectra.curve,
                         state.chromophores.curve, seconds};
}

}  // namespace cutis
