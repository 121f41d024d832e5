#pragma once

// What ChromNN is given: the channels of a rig as they were photographed, or combinations of them.
//
// Thread-safe: pure functions and values.

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/spectra/signature.h"

namespace cutis {

struct NetworkChannels {
  SpectrumRows rows;  // of the channels as they are photographed; each sums to 1
  // Rows: inputs of the network; columns: photographed channels. Empty: they are the inputs.
  Eigen::MatrixXd combination;
  std::vector<std::string> names;  // of the inputs: "white.R", "sb"

  int inputCount() const {
    return static_cast<int>(combination.size() > 0 ? combination.rows() : rows.rows());
  }
  // A person's or a pixel's channels a row, to its inputs.
  Eigen::MatrixXd inputs(const Eigen::MatrixXd& photographed) const;
};

// All channels of the rig.
NetworkChannels networkChannels(const Rig& rig);

// The paper's five: r, g, b under white, and the responses sb and sg to blue and green alone, made
// of the mixtures with white (core/rig/narrowband.h). Fails for a rig that has no such lights.
Result<NetworkChannels> paperNetworkChannels(const Rig& rig, const std::string& place);

// Equal but for rounding: the inputs of such channels see the same.
Signature signatureOf(const NetworkChannels& channels);

// Which channels of the rig a network of this signature takes: all, or the paper's five; nothing if
// it is of another rig.
std::optional<NetworkChannels> channelsOf(const Signature& inputs, const Rig& rig);

}  // namespace cutis
