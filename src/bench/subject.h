#pragma once  // internal to src/bench

// What is measured: skin in front of a rig, and the people of the error protocol
// (resources/manual/fitting.md) that all parts of the benchmark share.

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/base/tile_store.h"
#include "core/evaluate/error_metrics.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "src/app/engine.h"

namespace cutis {

struct BenchSubject {
  Engine& engine;  // outlives this
  std::shared_ptr<TileStore> store;
  std::shared_ptr<const SkinModel> model;
  Rig rig;
  std::shared_ptr<const ErrorMeter> meter;
  std::size_t pixels = 20000;
  std::size_t subsample = 2000;  // of the exhaustive searches
  double timingSeconds = 0.3;    // per method and noise
};

// The protocol's people must be skin of the profile; an error names the parameter whose range does
// not hold them.
Status checkHoldsProtocol(const Profile& profile);

// Errors of reflectance and of colour under D65 and A for the CIE 1931 observer.
Result<std::shared_ptr<const ErrorMeter>> protocolMeter(const SkinModel& model);

// People of the protocol, the same in all its parts.
std::vector<ParameterVector> benchPeople(std::size_t count);

}  // namespace cutis
