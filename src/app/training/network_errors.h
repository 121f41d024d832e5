#pragma once

// How well trained networks do.
//
// Thread-safe; uses all cores it may. Deterministic. Cancelled if asked to stop.

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "src/files/networks/network_file.h"

namespace cutis {

// Mean squared errors of reflectance, 400–700 nm, against SkinModel in double precision, over
// people of protocolPopulation().
struct NetworkErrors {
  double decoded = 0.0;  // parameters → SpectraNN
  double encoded = 0.0;  // channels → ChromNN → SkinModel: the error of fit --method network
  double both = 0.0;     // channels → ChromNN → SpectraNN
  double encodedNoisy = 0.0;  // the same two, of channels with the rig's noise
  double bothNoisy = 0.0;
};

// Precondition: the networks are of this profile. Fails where they are of another rig.
Result<NetworkErrors> measureNetworks(const SkinModel& model, const Rig& rig,
                                      const NetworkFile& file, const JobContext& context);

}  // namespace cutis
