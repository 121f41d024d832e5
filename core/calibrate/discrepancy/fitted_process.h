#pragma once

// The process of people (core/calibrate/discrepancy/discrepancy_process.h) from fits of their whole
// spectra, and how far it is off for somebody whom it was not learned from.
//
// Vectors are over the positions of the working samples that were measured. Thread-safe: pure
// functions.

#include <vector>

#include <Eigen/Core>

#include "core/calibrate/discrepancy/discrepancy_process.h"
#include "core/calibrate/discrepancy/whole_spectrum_fit.h"

namespace cutis {

// How much each person counts: nothing where the fit came to no end, and the less the further the
// spectrum is from what others leave over. deviations: what is expected at each position.
std::vector<double> weightsOf(const std::vector<WholeFit>& fits, const Eigen::VectorXd& deviations);

// smooth: over all working samples; what the process and its people are drawn towards. At least two
// people who count.
DiscrepancyProcess processOf(const std::vector<WholeFit>& fits, const std::vector<double>& weights,
                             const std::vector<Eigen::Index>& at, const DiscrepancyProcess& smooth);

// Mean square, over people, of what is left over of a person's spectrum when the process of all
// others has told it from the coefficients that are seen of it (seenComponents(),
// core/calibrate/discrepancy/discrepancy_reduction.h). The process's own variance is of the people
// whom it was learned from and less than that, the more so the fewer they are. reflectance: of a
// typical person, over all working samples. Two milliseconds a person.
Eigen::VectorXd leftOutVariance(const std::vector<WholeFit>& fits,
                                const std::vector<double>& weights,
                                const std::vector<Eigen::Index>& at,
                                const DiscrepancyProcess& smooth,
                                const Eigen::VectorXd& reflectance, int components);

}  // namespace cutis
