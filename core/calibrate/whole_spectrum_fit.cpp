#include "core/calibrate/whole_spectrum_fit.h"

#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "core/base/parallel.h"
#include "core/fit/coordinate_prior.h"
#include "core/maths/damped_search.h"
#include "core/maths/decompositions.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Equations = EquationsOf<kParameterCount>;

// In units of a variance: where the quadratic promises less than this, the search is over.
constexpr double kEnough = 1e-9;

// The first of the positions that takes part in fits.
Index firstTrusted(const WorkingSpectra& spectra) {
  Index first = 0;
  while (wavelengthNm(gridSample(spectra.at[static_cast<std::size_t>(first)])) < kTrustedFromNm)
    ++first;
  return first;
}

// What all fits of a round have in common.
class WholeFitter {
 public:
  WholeFitter(const InstrumentModel& instrument, const ParameterAxes& axes, const Prior& like,
              const DiscrepancyProcess& process, const WorkingSpectra& spectra)
      : instrument_(instrument),
        prior_(priorFrom(process.people, like)),
        box_(coordinatePrior(prior_, axes, {})),
        center_(process.people.mean),
        spectra_(spectra),
        first_(firstTrusted(spectra)),
        count_(static_cast<Index>(spectra.at.size()) - first_) {
    const std::vector<Index> fitted(spectra.at.begin() + first_, spectra.at.end());
    mean_ = process.mean(fitted);
    slope_ = process.slope(fitted, Eigen::all);
    covariance_ = process.covariance(fitted, fitted);
  }

  WholeFit fit(Index spectrum) const {
    const VectorXd measured = spectra_.measured.col(spectrum);
    MatrixXd covariance = covariance_;
    for (Index i = 0; i < count_; ++i)
      covariance(i, i) += readingVariance(measured[first_ + i]);
    const Eigen::LLT<MatrixXd> whitening(covariance);

    // The search is in the unit box.
    const Coordinates range = (box_.high - box_.low).matrix();
    Coordinates best = box_.mean.max(box_.low).min(box_.high).matrix(), trial = best;
    Equations found;
    DampedSearch<kParameterCount> search({});
    Coordinates step;
    do {
      const Equations at = equations(measured, whitening, trial);
      if (search.improves(at.cost)) {
        best = trial;
        found = at;
        search.accept({range.asDiagonal() * at.hessian * range.asDiagonal(),
                       range.cwiseProduct(at.downhill), at.cost});
      } else {
        search.reject();
      }
      const Coordinates inBox = (best - box_.low.matrix()).cwiseQuotient(range);
      if (!search.next(inBox, kEnough, step)) break;
      trial = (best + range.cwiseProduct(step))
                  .cwiseMax(box_.low.matrix())
                  .cwiseMin(box_.high.matrix());
    } while (true);

    WholeFit result;
    result.coordinates = best;
    result.covariance = inverseOfPositive<kParameterCount>(found.hessian);
    result.leftOver = leftOver(measured, parametersOf(prior_, best));
    result.converged = search.converged() && result.leftOver.allFinite();
    return result;
  }

 private:
  Equations equations(const VectorXd& measured, const Eigen::LLT<MatrixXd>& whitening,
                      const Coordinates& coordinates) const {
    const ParameterVector parameters = parametersOf(prior_, coordinates);
    const Coordinates away = coordinates - center_;
    VectorXd residual(count_);
    Eigen::Matrix<double, Eigen::Dynamic, kParameterCount> slopes(count_, kParameterCount);
    for (Index i = 0; i < count_; ++i) {
      const Index position = first_ + i;
      ParameterVector byParameter;
      const double modelled = instrument_.reflectanceAt(
          gridSample(spectra_.at[static_cast<std::size_t>(position)]), parameters, byParameter);
      const double scale = (1.0 + mean_[i]) / measured[position];
      residual[i] = 1.0 - scale * modelled - slope_.row(i).dot(away);
      for (int k = 0; k < kParameterCount; ++k) {
        const double chain = prior_.isLog(k) ? parameters[k] : 1.0;
        slopes(i, k) = scale * byParameter[k] * chain + slope_(i, k);
      }
    }
    whitening.matrixL().solveInPlace(residual);
    whitening.matrixL().solveInPlace(slopes);
    Equations sums;
    sums.hessian = slopes.transpose() * slopes + box_.precision;
    sums.downhill = slopes.transpose() * residual - box_.precision * away;
    sums.cost = residual.squaredNorm() + away.dot(box_.precision * away);
    return sums;
  }

  VectorXd leftOver(const VectorXd& measured, const ParameterVector& parameters) const {
    VectorXd result(measured.size());
    for (Index i = 0; i < result.size(); ++i) {
      const int sample = gridSample(spectra_.at[static_cast<std::size_t>(i)]);
      result[i] = measured[i] / instrument_.reflectanceAt(sample, parameters) - 1.0;
    }
    return result;
  }

  const InstrumentModel& instrument_;
  Prior prior_;
  CoordinatePrior box_;
  Coordinates center_;
  const WorkingSpectra& spectra_;
  Index first_, count_;
  VectorXd mean_;
  MatrixXd slope_, covariance_;
};

}  // namespace

Result<std::vector<WholeFit>> fitWholeSpectra(const InstrumentModel& instrument,
                                              const ParameterAxes& axes, const Prior& like,
                                              const DiscrepancyProcess& process,
                                              const WorkingSpectra& spectra,
                                              const JobContext& context) {
  const WholeFitter fitter(instrument, axes, like, process, spectra);
  std::vector<WholeFit> fits(static_cast<std::size_t>(spectra.measured.cols()));
  CUTIS_CHECK(parallelFor(fits.size(), context, [&](std::size_t i) -> Status {
    fits[i] = fitter.fit(static_cast<Index>(i));
    return {};
  }));
  return fits;
}

}  // namespace cutis
