#pragma once

// A discrepancy's process, reduced to the few components that maps can hold.
//
// Vectors are over working samples, all of them or those that were measured. Thread-safe: pure
// functions.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/calibrate/discrepancy/discrepancy_process.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/discrepancy.h"

namespace cutis {

// Which of some working samples cameras see, from 380 to 740 nm: positions among them.
std::vector<Eigen::Index> seenOf(std::span<const Eigen::Index> at);

// The model's, of people like the process's mean, at all working samples. like: as in priorFrom().
Eigen::VectorXd typicalReflectance(const DiscrepancyProcess& process, const SkinModel& model,
                                   const Prior& like);

// The components of the greatest variance of reflectance over what is seen, each with a coefficient
// of variance 1.
struct SeenComponents {
  Eigen::MatrixXd coefficients;  // of what is seen of a discrepancy, [coefficient][seen]
  Eigen::MatrixXd spectra;       // what goes with each everywhere, [sample][coefficient]
};
SeenComponents seenComponents(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& reflectance,
                              const std::vector<Eigen::Index>& seen, int count);

// The seen components of a process of all working samples. What they leave over goes to `rest`:
// eight more spectra, and an independent deviation for what these leave over of the variance, or of
// leftOut where that is more (leftOutVariance(), core/calibrate/discrepancy/fitted_process.h; zero
// where nothing was measured). reflectance: typicalReflectance().
Discrepancy reduced(const DiscrepancyProcess& process, const Eigen::VectorXd& reflectance,
                    const Eigen::VectorXd& leftOut, int components, const Prior& like);

}  // namespace cutis
