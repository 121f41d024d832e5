#include "src/app/training/usual_training.h"

#include "src/files/io/csv.h"

namespace cutis {

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

}  // namespace cutis
