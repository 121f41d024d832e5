#include "core/neural/network_channels.h"

#include <cstddef>
#include <span>

#include "core/base/echoed_text.h"
#include "core/rig/narrowband.h"

namespace cutis {

Eigen::MatrixXd NetworkChannels::inputs(const Eigen::MatrixXd& photographed) const {
  if (combination.size() == 0) return photographed;
  return photographed * combination.transpose();
}

NetworkChannels networkChannels(const Rig& rig) {
  NetworkChannels channels = {responseRows(rig), {}, {}};
  for (int k = 0; k < rig.channelCount(); ++k)
    channels.names.push_back(rig.channelName(k));
  return channels;
}

Result<NetworkChannels> paperNetworkChannels(const Rig& rig, const std::string& place) {
  const SearchChannels search = searchChannels(rig);
  if (!search.hasNarrowband()) {
    return inputError(place,
                      "the paper's channels sb and sg are made of lights white+blue and "
                      "white+green that mix primaries of white, which rig " +
                          inQuotes(rig.name) + " does not have; take all of its channels");
  }
  return NetworkChannels{responseRows(rig), search.fromRig, {"r", "g", "b", "sb", "sg"}};
}

Signature signatureOf(const NetworkChannels& channels) {
  SpectrumRows seen = channels.rows;
  if (channels.combination.size() > 0) seen = (channels.combination * seen.matrix()).eval();
  SignatureBuilder builder;
  for (Eigen::Index k = 0; k < seen.rows(); ++k) {
    builder.add(std::span<const double>(seen.row(k).data(), std::size_t{kSampleCount}));
  }
  return builder.signature();
}

std::optional<NetworkChannels> channelsOf(const Signature& inputs, const Rig& rig) {
  NetworkChannels all = networkChannels(rig);
  if (alike(inputs, signatureOf(all))) return all;
  auto paper = paperNetworkChannels(rig, "");
  if (paper && alike(inputs, signatureOf(paper.value()))) return std::move(paper).value();
  return std::nullopt;
}

}  // namespace cutis
