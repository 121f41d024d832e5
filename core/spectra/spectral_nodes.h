#pragma once

// Spectral nodes: the few wavelengths at which a spectrum must be known to know its channels.
//
// The reflectance of skin lies close to a small affine space, so any weighted sum over the grid (a
// camera channel, XYZ under a light, a UV band) is, to a stated error, a weighted sum at a dozen
// wavelengths with weights of their own. Chosen by forward selection with exchange: add the sample
// that lowers the squared error most, then replace each node in turn by whatever is better until
// nothing is.

#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/spectra/grid.h"

namespace cutis {

struct NodeOptions {
  // Root mean square over all rows and spectra at which to stop.
  double rmsTolerance = 1e-5;
  int maximumNodes = 40;
};

struct SpectralNodes {
  std::vector<int> samples;  // positions on the grid, increasing
  Eigen::MatrixXd weights;   // rows × nodes
  // Errors over the spectra set aside for checking, in the unit of the rows.
  double rmsError = 0.0;
  double worstError = 0.0;
};

// rows: the sums to reproduce. training, checking: one spectrum per row, sampled by the caller from
// what will be asked later; checking must not repeat training. Only samples where some row is not
// zero are candidates. Deterministic; about 50 ms for a rig.
SpectralNodes chooseSpectralNodes(const SpectrumRows& rows, const SpectrumRows& training,
                                  const SpectrumRows& checking, const NodeOptions& options = {});

}  // namespace cutis
