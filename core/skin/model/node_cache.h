#pragma once  // internal to core/skin/model

// Spectral nodes chosen so far, of one skin model. A choice costs tens of milliseconds and the same
// rows are asked for again and again: by each fit with a rig, by each view under a light.
//
// Thread-safe. Two threads that ask for the same at once may both choose; they choose alike.

#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "core/spectra/spectral_nodes.h"

namespace cutis {

class NodeCache {
 public:
  // What was chosen for these rows and options, else what `choose` returns.
  SpectralNodes get(const SpectrumRows& rows, const NodeOptions& options,
                    const std::function<SpectralNodes()>& choose);

 private:
  std::mutex mutex_;
  std::map<std::string, SpectralNodes> known_;  // by content hash
};

}  // namespace cutis
