#pragma once

// People fitted to the whole of their spectra, where what the model leaves over is a random
// function of the wavelength: the inner part of core/calibrate/discrepancy_learning.h.
//
// Maximum a posteriori under the normal distribution of the process's people, by damped
// Gauss–Newton steps within the profile's ranges. The process is relative to what was measured,
// which keeps the problem linear in it.

#include <vector>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/calibrate/discrepancy/discrepancy_process.h"
#include "core/skin/model/instrument_model.h"

namespace cutis {

// What of the working samples was measured: positions among them, increasing, and reflectances.
struct WorkingSpectra {
  std::vector<Eigen::Index> at;
  Eigen::MatrixXd measured;  // [position][spectrum], positive
};

struct WholeFit {
  Coordinates coordinates = Coordinates::Zero();
  ParameterMatrix covariance = ParameterMatrix::Zero();  // posterior, of the coordinates
  Eigen::VectorXd leftOver;  // measured over modelled, less 1; [position]
  bool converged = false;
};

// like: which coordinates are logarithms. Wavelengths below kTrustedFromNm take no part in the fit.
// Cancelled or out of memory. 2 ms a spectrum on one core; same result for any number of threads.
Result<std::vector<WholeFit>> fitWholeSpectra(const InstrumentModel& instrument,
                                              const ParameterAxes& axes, const Prior& like,
                                              const DiscrepancyProcess& process,
                                              const WorkingSpectra& spectra,
                                              const JobContext& context);

// Proteins of the skin absorb below it, of which models of the visible range know little.
inline constexpr double kTrustedFromNm = 320.0;

}  // namespace cutis
