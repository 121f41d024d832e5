#pragma once

// Narrowband responses synthesised from mixtures with white (paper, §3.2).
//
// A display adds light, so a mixture is k times white plus light of one primary, and the response
// to that primary alone follows linearly. With W = Σ S L,
//
//   sb = (W_wb y_wb − k W_w y_w) / (W_wb − k W_w)      in the blue sensor, sg likewise in the
//   green.
//
// Exact for any skin; the paper adapts chromatically instead (Gitlina et al. 2020).

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/rig/rig.h"

namespace cutis {

// The measurements the table searches compare: r, g, b under white, then sb and sg if the rig has
// the lights `white+blue` and `white+green` as mixes of its primaries beside `white`.
struct SearchChannels {
  // Rows: r, g, b[, sb, sg]; columns: the rig's channels.
  Eigen::MatrixXd fromRig;
  bool hasNarrowband() const { return fromRig.rows() == 5; }
};

// A rig without a light called `white` is searched by its first light.
SearchChannels searchChannels(const Rig& rig);

}  // namespace cutis
