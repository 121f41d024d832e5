#include "core/calibrate/discrepancy/whole_spectrum_fit.h"

#include <algorithm>
#include <utility>

#include <Eigen/Cholesky>

#include "core/base/parallel.h"
#include "core/calibrate/discrepancy/coordinate_search.h"
#include "core/maths/decompositions.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What little remains of the model's reflectance is error, wherever that is more than it.
constexpr double kLeastLeftOver = -0.85;

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
        like_(like),
        prior_(coordinatePrior(priorFrom(process.people, like), axes, {})),
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

    const FoundCoordinates found = searchCoordinates(prior_, [&](const Coordinates& coordinates) {
      return equations(measured, whitening, coordinates);
    });
    WholeFit result;
    result.coordinates = found.coordinates;
    result.covariance = inverseOfPositive<kParameterCount>(found.equations.hessian);
    result.leftOver = leftOver(measured, parametersOf(like_, found.coordinates));
    result.converged = found.converged && result.leftOver.allFinite();
    return result;
  }

 private:
  CoordinateEquations equations(const VectorXd& measured, const Eigen::LLT<MatrixXd>& whitening,
                                const Coordinates& coordinates) const {
    const ParameterVector parameters = parametersOf(like_, coordinates);
    const Coordinates away = coordinates - prior_.mean.matrix();
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
        const double chain = like_.isLog(k) ? parameters[k] : 1.0;
        slopes(i, k) = scale * byParameter[k] * chain + slope_(i, k);
      }
    }
    whitening.matrixL().solveInPlace(residual);
    whitening.matrixL().solveInPlace(slopes);
    CoordinateEquations sums;
    sums.hessian = slopes.transpose() * slopes;
    sums.downhill = slopes.transpose() * residual;
    sums.cost = residual.squaredNorm();
    addPrior(prior_, coordinates, sums);
    return sums;
  }

  VectorXd leftOver(const VectorXd& measured, const ParameterVector& parameters) const {
    VectorXd result(measured.size());
    for (Index i = 0; i < result.size(); ++i) {
      const int sample = gridSample(spectra_.at[static_cast<std::size_t>(i)]);
      const double left = measured[i] / instrument_.reflectanceAt(sample, parameters) - 1.0;
      result[i] = std::max(left, kLeastLeftOver);
    }
    return result;
  }

  const InstrumentModel& instrument_;
  const Prior& like_;
  CoordinatePrior prior_;
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
