#include "core/calibrate/calibration.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <Eigen/Cholesky>

#include "core/calibrate/fitted_people.h"
#include "core/calibrate/point_model.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaximumRounds = 40;
// Converged: a step lowered the sum by less than this share. The layer tables of two points differ
// in what they leave out, so that the sum is not smooth below that.
constexpr double kRelativeGain = 5e-4;
// Nor does it matter by how little errors a thousand times below their aims fall.
constexpr double kAbsoluteGain = 1e-6;
constexpr int kMaximumAttempts = 8;
constexpr double kFirstDamping = 1e-3;
// A share of a constant's range. The layer tables of two points differ by up to 1e-5 in what they
// leave out, which shorter steps would take for a derivative.
constexpr double kDerivativeStep = 5e-3;
constexpr double kLongestStep = 0.3;

std::vector<int> allSamples(const CalibrationProblem& problem) {
  std::vector<int> samples;
  for (const SpectraSet& set : problem.sets) {
    samples.insert(samples.end(), set.samples.begin(), set.samples.end());
  }
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  return samples;
}

bool isSlight(double gain, double cost) {
  return gain < kRelativeGain * cost + kAbsoluteGain;
}

// Coordinates are the constants' places in their ranges, 0 to 1.
class Calibrator {
 public:
  Calibrator(const CalibrationProblem& problem, const JobContext& context)
      : problem_(problem), context_{context.stop, {}, {}}, samples_(allSamples(problem)) {}

  Result<Calibration> run(const std::vector<double>& start, const Progress& progress) {
    CUTIS_CHECK(place(coordinatesOf(start), {}, current_));
    Calibration result;
    double damping = kFirstDamping;
    while (!result.converged && result.rounds < kMaximumRounds) {
      CUTIS_TRY(equations, linearise());
      const double before = current_.cost;
      CUTIS_TRY(moved, advance(equations, damping));
      if (!moved || isSlight(before - current_.cost, before)) {
        CUTIS_TRY(found, searchAgain());
        result.converged = !found;
        damping = kFirstDamping;
      }
      ++result.rounds;
      progress.report(static_cast<double>(result.rounds) / kMaximumRounds);
    }
    result.constants = constantsAt(current_.x);
    result.cost = current_.cost;
    return result;
  }

 private:
  struct State {
    VectorXd x;
    std::shared_ptr<const PointModel> model;
    std::vector<SetPeople> people;
    double cost = 0.0;
  };

  double widthOf(std::size_t k) const {
    return problem_.constants[k].high - problem_.constants[k].low;
  }

  VectorXd coordinatesOf(const std::vector<double>& constants) const {
    VectorXd x(static_cast<Index>(constants.size()));
    for (std::size_t k = 0; k < constants.size(); ++k) {
      const double place = (constants[k] - problem_.constants[k].low) / widthOf(k);
      x[static_cast<Index>(k)] = std::clamp(place, 0.0, 1.0);
    }
    return x;
  }

  std::vector<double> constantsAt(const VectorXd& x) const {
    std::vector<double> constants;
    for (std::size_t k = 0; k < problem_.constants.size(); ++k) {
      constants.push_back(problem_.constants[k].low + x[static_cast<Index>(k)] * widthOf(k));
    }
    return constants;
  }

  // How far a constant is from what is expected, in deviations, and its slope by the coordinate.
  std::pair<double, double> away(std::size_t k, double constant) const {
    const CalibratedConstant& known = problem_.constants[k];
    if (!known.isLog) {
      return {(constant - known.expected) / known.deviation, widthOf(k) / known.deviation};
    }
    return {std::log(constant / known.expected) / known.deviation,
            widthOf(k) / (constant * known.deviation)};
  }

  Result<PointModel> modelAt(const VectorXd& x, const PointModel* like) const {
    CUTIS_TRY(point, problem_.pointAt(constantsAt(x)));
    return PointModel::make(point, samples_, like, context_);
  }

  // People follow the constants from where they were and may so be left behind in a place that no
  // longer is their lowest. Whether a search from elsewhere lowers the sum; if so, it is taken.
  Result<bool> searchAgain() {
    State afresh;
    CUTIS_CHECK(place(current_.x, {}, afresh));
    const bool found = !isSlight(current_.cost - afresh.cost, current_.cost);
    if (found) current_ = std::move(afresh);
    return found;
  }

  // Fits everyone at x: from these people or, where there are none, from a search.
  Status place(const VectorXd& x, const std::vector<SetPeople>& starts, State& state) const {
    CUTIS_TRY(model, modelAt(x, nullptr));
    State next = {x, std::make_shared<const PointModel>(std::move(model)), {}, 0.0};
    for (std::size_t set = 0; set < problem_.sets.size(); ++set) {
      const SetPeople from = starts.empty() ? SetPeople() : starts[set];
      CUTIS_TRY(people, fitPeople(*next.model, set, problem_.sets[set], from, context_));
      CUTIS_TRY(aims, aimEquations(*next.model, {}, {}, set, problem_.sets[set], people, context_));
      next.people.push_back(std::move(people));
      next.cost += aims.cost;
    }
    const std::vector<double> constants = constantsAt(x);
    for (std::size_t k = 0; k < constants.size(); ++k) {
      next.cost += problem_.pull * std::pow(away(k, constants[k]).first, 2);
    }
    state = std::move(next);
    return {};
  }

  Result<AimEquations> linearise() const {
    std::vector<PointModel> stepped;
    std::vector<double> steps;
    for (Index k = 0; k < current_.x.size(); ++k) {
      VectorXd x = current_.x;
      steps.push_back(x[k] < 0.5 ? kDerivativeStep : -kDerivativeStep);
      x[k] += steps.back();
      CUTIS_TRY(model, modelAt(x, current_.model.get()));
      stepped.push_back(std::move(model));
    }
    AimEquations total = {MatrixXd::Zero(current_.x.size(), current_.x.size()),
                          VectorXd::Zero(current_.x.size()), 0.0};
    for (std::size_t set = 0; set < problem_.sets.size(); ++set) {
      CUTIS_TRY(aims, aimEquations(*current_.model, stepped, steps, set, problem_.sets[set],
                                   current_.people[set], context_));
      total.hessian += aims.hessian;
      total.gradient += aims.gradient;
    }
    const std::vector<double> constants = constantsAt(current_.x);
    for (Index k = 0; k < current_.x.size(); ++k) {
      const auto index = static_cast<std::size_t>(k);
      const auto [distance, slope] = away(index, constants[index]);
      total.hessian(k, k) += problem_.pull * slope * slope;
      total.gradient[k] += problem_.pull * distance * slope;
    }
    return total;
  }

  // One step downhill; false when none is found.
  Result<bool> advance(const AimEquations& equations, double& damping) {
    for (int attempt = 0; attempt < kMaximumAttempts; ++attempt) {
      State trial;
      CUTIS_CHECK(place(stepped(equations, damping), current_.people, trial));
      if (trial.cost < current_.cost) {
        current_ = std::move(trial);
        damping *= 0.2;
        return true;
      }
      damping = std::max(damping, 1e-6) * 8.0;
    }
    return false;
  }

  // Coordinates at a bound whose way down leads out are held.
  VectorXd stepped(const AimEquations& equations, double damping) const {
    MatrixXd hessian = equations.hessian;
    hessian.diagonal() *= 1.0 + damping;
    hessian.diagonal().array() += 1e-12 * (1.0 + equations.hessian.trace());
    VectorXd downhill = -equations.gradient;
    for (Index k = 0; k < downhill.size(); ++k) {
      const bool held = (current_.x[k] <= 0.0 && downhill[k] <= 0.0) ||
                        (current_.x[k] >= 1.0 && downhill[k] >= 0.0);
      if (!held) continue;
      hessian.row(k).setZero();
      hessian.col(k).setZero();
      hessian(k, k) = 1.0;
      downhill[k] = 0.0;
    }
    const VectorXd step =
        hessian.ldlt().solve(downhill).cwiseMax(-kLongestStep).cwiseMin(kLongestStep);
    return (current_.x + step).cwiseMax(0.0).cwiseMin(1.0);
  }

  const CalibrationProblem& problem_;
  JobContext context_;
  std::vector<int> samples_;
  State current_;
};

}  // namespace

SpectraSet selected(const SpectraSet& set, std::span<const std::size_t> spectra) {
  SpectraSet some = {set.samples, Eigen::ArrayXXd(set.measured.rows(), spectra.size()), set.aims};
  for (std::size_t i = 0; i < spectra.size(); ++i) {
    some.measured.col(static_cast<Index>(i)) = set.measured.col(static_cast<Index>(spectra[i]));
  }
  return some;
}

Result<Calibration> calibrate(const CalibrationProblem& problem, const std::vector<double>& start,
                              const JobContext& context) {
  return Calibrator(problem, context).run(start, context.progress);
}

}  // namespace cutis
