#include "core/calibrate/fitted_range.h"

#include "core/spectra/grid.h"

namespace cutis {

using Eigen::Index;

bool liesWithin(int sample, double fromNm, double toNm) {
  return wavelengthNm(sample) >= fromNm && wavelengthNm(sample) <= toNm;
}

std::vector<Index> fittedRows(const SpectraSet& set) {
  std::vector<Index> rows;
  for (std::size_t s = 0; s < set.samples.size(); ++s) {
    if (liesWithin(set.samples[s], kFittedFromNm, kFittedToNm)) {
      rows.push_back(static_cast<Index>(s));
    }
  }
  return rows;
}

SpectralNodes fittedNodes(const SpectraSet& set) {
  SpectralNodes nodes;
  for (const Index row : fittedRows(set)) {
    nodes.samples.push_back(set.samples[static_cast<std::size_t>(row)]);
  }
  const auto count = static_cast<Index>(nodes.samples.size());
  nodes.weights = Eigen::MatrixXd::Identity(count, count);
  return nodes;
}

}  // namespace cutis
