#include "core/calibrate/discrepancy/coordinate_search.h"

#include "core/maths/damped_search.h"

namespace cutis {
namespace {

// In units of a variance: where the quadratic promises less than this, the search is over.
constexpr double kEnough = 1e-9;

}  // namespace

FoundCoordinates searchCoordinates(
    const CoordinatePrior& box,
    const std::function<CoordinateEquations(const Coordinates&)>& equations) {
  const Coordinates low = box.low.matrix(), high = box.high.matrix();
  const Coordinates range = high - low;  // the search is in the unit box
  DampedSearch<kParameterCount> search({});
  FoundCoordinates found;
  Coordinates trial = box.mean.matrix().cwiseMax(low).cwiseMin(high);
  Coordinates step;
  do {
    const CoordinateEquations at = equations(trial);
    if (search.improves(at.cost)) {
      found.coordinates = trial;
      found.equations = at;
      search.accept({range.asDiagonal() * at.hessian * range.asDiagonal(),
                     range.cwiseProduct(at.downhill), at.cost});
    } else {
      search.reject();
    }
    const bool goesOn = search.next((found.coordinates - low).cwiseQuotient(range), kEnough, step);
    if (!goesOn) break;
    trial = (found.coordinates + range.cwiseProduct(step)).cwiseMax(low).cwiseMin(high);
  } while (true);
  found.converged = search.converged();
  return found;
}

void addPrior(const CoordinatePrior& prior, const Coordinates& coordinates,
              CoordinateEquations& equations) {
  const Coordinates away = coordinates - prior.mean.matrix();
  const Coordinates pull = prior.precision * away;
  equations.hessian += prior.precision;
  equations.downhill -= pull;
  equations.cost += away.dot(pull);
}

}  // namespace cutis
