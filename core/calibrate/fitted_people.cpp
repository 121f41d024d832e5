#include "core/calibrate/fitted_people.h"

#include <algorithm>
#include <array>

#include <Eigen/Cholesky>

#include "core/base/parallel.h"
#include "core/calibrate/fitted_range.h"
#include "core/fit/reference/map_estimator.h"
#include "core/fit/spectra/spectra_fit.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A parameter within this share of its range from an end is at it and stays there.
constexpr double kAtBound = 1e-9;
// Added to the diagonal of the people's normal equations, as a share of its mean: what does not act
// on a spectrum stays in place.
constexpr double kRidge = 1e-10;
// A share of a parameter's range, for second derivatives.
constexpr double kPersonStep = 1e-5;

// How much each sample's squared residual of a spectrum counts.
VectorXd weightsOf(const SpectraSet& set) {
  VectorXd weights = VectorXd::Zero(static_cast<Index>(set.samples.size()));
  for (const SpectralAim& aim : set.aims) {
    VectorXd inside = VectorXd::Zero(weights.size());
    for (Index s = 0; s < inside.size(); ++s) {
      if (liesWithin(set.samples[static_cast<std::size_t>(s)], aim.fromNm, aim.toNm))
        inside[s] = 1.0;
    }
    if (inside.sum() == 0.0) continue;
    const double values = inside.sum() * static_cast<double>(set.count());
    weights += inside / (values * aim.rms * aim.rms);
  }
  return weights;
}

// Without starts, the best of several searches is kept for each person.
Result<SetPeople> searchPeople(const PointModel& model, std::size_t set, const SpectraSet& spectra,
                               const JobContext& context) {
  const std::vector<Index> rows = fittedRows(spectra);
  std::vector<double> wavelengths, reflectances;
  for (const Index row : rows) {
    wavelengths.push_back(wavelengthNm(spectra.samples[static_cast<std::size_t>(row)]));
  }
  for (Index i = 0; i < spectra.count(); ++i) {
    for (const Index row : rows)
      reflectances.push_back(spectra.measured(row, i));
  }
  CUTIS_TRY(fits, fitSpectra(model.skin(), wavelengths, reflectances, context,
                             model.asSeenBy(set).geometry()));
  SetPeople people;
  for (const SpectrumFit& fit : fits)
    people.push_back(fit.parameters);
  return people;
}

// One spectrum and the person it is of, in parameters over their ranges.
class SpectrumTerm {
 public:
  SpectrumTerm(const SpectraSet& spectra, std::size_t set, const ParameterAxes& axes,
               const ParameterVector& person, Index spectrum)
      : spectra_(spectra), set_(set), person_(person), spectrum_(spectrum) {
    for (int k = 0; k < kParameterCount; ++k) {
      range_[k] = axes[static_cast<std::size_t>(k)].maximum;
      isFree_[static_cast<std::size_t>(k)] =
          person[k] > kAtBound * range_[k] && person[k] < (1.0 - kAtBound) * range_[k];
    }
  }

  // Modelled minus measured, and the model's derivatives by the person, at all samples; held
  // parameters have none.
  struct Linearisation {
    VectorXd residual;
    MatrixXd byParameter;
  };
  Linearisation linearise(const PointModel& model) const { return lineariseAt(model, person_); }

  VectorXd slopeOf(const Linearisation& at, const std::vector<Index>& fitted) const {
    return at.byParameter(fitted, Eigen::all).transpose() * at.residual(fitted);
  }

  // How the person follows: what moves the slopes of the misfit by `slopes`, one column each, back
  // to where they are. The misfit's second derivatives count in full: along a valley, where spectra
  // say little, they are all there is.
  MatrixXd following(const PointModel& model, const Linearisation& at, const MatrixXd& slopes,
                     const std::vector<Index>& fitted) const {
    const VectorXd slope = slopeOf(at, fitted);
    MatrixXd hessian = MatrixXd::Zero(kParameterCount, kParameterCount);
    for (int k = 0; k < kParameterCount; ++k) {
      if (!isFree_[static_cast<std::size_t>(k)]) continue;
      ParameterVector person = person_;
      const double step = person[k] < 0.5 * range_[k] ? kPersonStep : -kPersonStep;
      person[k] += step * range_[k];
      hessian.col(k) = (slopeOf(lineariseAt(model, person), fitted) - slope) / step;
    }
    hessian = 0.5 * (hessian + hessian.transpose().eval());
    const MatrixXd gauss =
        at.byParameter(fitted, Eigen::all).transpose() * at.byParameter(fitted, Eigen::all);
    const double ridge = kRidge * gauss.trace() + 1e-30;
    hessian.diagonal().array() += ridge;
    const Eigen::LLT<MatrixXd> newton(hessian);
    if (newton.info() == Eigen::Success) return newton.solve(-slopes);
    hessian = gauss;
    hessian.diagonal().array() += ridge;
    return hessian.llt().solve(-slopes);
  }

 private:
  Linearisation lineariseAt(const PointModel& model, const ParameterVector& person) const {
    const auto count = static_cast<Index>(spectra_.samples.size());
    Linearisation at = {VectorXd(count), MatrixXd::Zero(count, kParameterCount)};
    for (Index s = 0; s < count; ++s) {
      ParameterVector derivatives;
      const double modelled = model.asSeenBy(set_).reflectanceAt(
          spectra_.samples[static_cast<std::size_t>(s)], person, derivatives);
      at.residual[s] = modelled - spectra_.measured(s, spectrum_);
      for (int k = 0; k < kParameterCount; ++k) {
        if (isFree_[static_cast<std::size_t>(k)]) at.byParameter(s, k) = derivatives[k] * range_[k];
      }
    }
    return at;
  }

  const SpectraSet& spectra_;
  std::size_t set_;
  ParameterVector person_;
  Index spectrum_;
  ParameterVector range_;
  std::array<bool, kParameterCount> isFree_;
};

AimEquations noEquations(std::size_t constants) {
  const auto count = static_cast<Index>(constants);
  return {MatrixXd::Zero(count, count), VectorXd::Zero(count), 0.0};
}

}  // namespace

Result<SetPeople> fitPeople(const PointModel& model, std::size_t set, const SpectraSet& spectra,
                            const SetPeople& starts, const JobContext& context) {
  if (starts.empty()) return searchPeople(model, set, spectra, context);
  const std::vector<Index> rows = fittedRows(spectra);
  EstimatorOptions options;
  options.noise = {1.0, 0.0};
  options.geometry = model.asSeenBy(set).geometry();
  const MapEstimator estimator(model.skin(), fittedNodes(spectra), options);
  SetPeople people(starts.size());
  CUTIS_CHECK(parallelFor(people.size(), context, [&](std::size_t i) -> Status {
    const VectorXd channels = spectra.measured.matrix().col(static_cast<Index>(i))(rows);
    people[i] = estimator.solve(channels, starts[i]).parameters;
    return {};
  }));
  return people;
}

Result<AimEquations> aimEquations(const PointModel& model, std::span<const PointModel> stepped,
                                  std::span<const double> steps, std::size_t set,
                                  const SpectraSet& spectra, const SetPeople& people,
                                  const JobContext& context) {
  // Sums of many spectra each, added up in order.
  constexpr std::size_t kSpectraPerPiece = 32;
  const VectorXd weights = weightsOf(spectra);
  const std::vector<Index> fitted = fittedRows(spectra);
  const ParameterAxes& axes = model.skin().profile().axes;
  const auto constants = static_cast<Index>(stepped.size());
  const auto addSpectrum = [&](std::size_t i, AimEquations& sum) {
    const SpectrumTerm term(spectra, set, axes, people[i], static_cast<Index>(i));
    const SpectrumTerm::Linearisation at = term.linearise(model);
    sum.cost += at.residual.dot(weights.cwiseProduct(at.residual));
    if (constants == 0) return;
    MatrixXd byConstant(at.residual.size(), constants);
    MatrixXd slopes(kParameterCount, constants);
    const VectorXd slope = term.slopeOf(at, fitted);
    for (Index k = 0; k < constants; ++k) {
      const auto index = static_cast<std::size_t>(k);
      const SpectrumTerm::Linearisation there = term.linearise(stepped[index]);
      byConstant.col(k) = (there.residual - at.residual) / steps[index];
      slopes.col(k) = (term.slopeOf(there, fitted) - slope) / steps[index];
    }
    byConstant += at.byParameter * term.following(model, at, slopes, fitted);
    const MatrixXd weighted = weights.asDiagonal() * byConstant;
    sum.hessian += byConstant.transpose() * weighted;
    sum.gradient += weighted.transpose() * at.residual;
  };
  const std::size_t pieces = (people.size() + kSpectraPerPiece - 1) / kSpectraPerPiece;
  std::vector<AimEquations> sums(pieces, noEquations(stepped.size()));
  CUTIS_CHECK(parallelFor(pieces, context, [&](std::size_t piece) -> Status {
    const std::size_t end = std::min(people.size(), (piece + 1) * kSpectraPerPiece);
    for (std::size_t i = piece * kSpectraPerPiece; i < end; ++i)
      addSpectrum(i, sums[piece]);
    return {};
  }));
  AimEquations total = noEquations(stepped.size());
  for (const AimEquations& sum : sums) {
    total.hessian += sum.hessian;
    total.gradient += sum.gradient;
    total.cost += sum.cost;
  }
  return total;
}

}  // namespace cutis
