#pragma once  // internal to core/calibrate

// The part of a set of spectra that people are fitted to.

#include <vector>

#include <Eigen/Core>

#include "core/calibrate/calibration.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

// Whether a position on the grid lies in a range of wavelengths, ends included.
bool liesWithin(int sample, double fromNm, double toNm);

// Rows of `measured` in the fitted range.
std::vector<Eigen::Index> fittedRows(const SpectraSet& set);

// Its samples, each a channel of its own.
SpectralNodes fittedNodes(const SpectraSet& set);

}  // namespace cutis
