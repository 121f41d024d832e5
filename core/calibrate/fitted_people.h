#pragma once  // internal to core/calibrate

// The people of a calibration: whom the spectra are of, at one choice of constants. The inner part
// of core/calibrate/calibration.cpp.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/calibrate/calibration.h"
#include "core/calibrate/point_model.h"

namespace cutis {

// Parameters of each spectrum of a set.
using SetPeople = std::vector<ParameterVector>;

// The parameters that come closest to each spectrum within the fitted range. Searches begin at
// `starts`, one per spectrum, or where that is empty at several points of the box. Errors: out of
// memory. Cancelled if asked to stop.
Result<SetPeople> fitPeople(const PointModel& model, std::size_t set, const SpectraSet& spectra,
                            const SetPeople& starts, const JobContext& context);

// Half the gradient and half the Gauss–Newton matrix of the aims by the constants, people
// following; and the aims' sum of squares, each over its own square and the number of values.
struct AimEquations {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;
  double cost = 0.0;
};

// The aims of one set. stepped: the models of points where one constant each has moved by `steps`;
// empty: the cost alone. Cancelled or out of memory.
Result<AimEquations> aimEquations(const PointModel& model, std::span<const PointModel> stepped,
                                  std::span<const double> steps, std::size_t set,
                                  const SpectraSet& spectra, const SetPeople& people,
                                  const JobContext& context);

}  // namespace cutis
