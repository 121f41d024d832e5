#include "core/fit/spectra_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/parallel.h"
#include "core/fit/bounded_step.h"
#include "core/fit/spectra_equations.h"
#include "core/skin/parameter_sampling.h"

namespace cutis {
namespace {

constexpr std::size_t kSpectraPerPiece = 16;
// Samples of the box to begin among. Little blood in the dermis and much of it may fit a spectrum
// alike, with nothing lower between, so the nearest are taken from each of several parts of its
// range.
constexpr int kSamples = 8192;
constexpr std::size_t kParts = 4;
constexpr std::size_t kStartsPerPart = 2;
constexpr std::size_t kStarts = kParts * kStartsPerPart;
// To find the nearest, more wavelengths than this tell no more.
constexpr Eigen::Index kComparedWavelengths = 32;
constexpr int kMaximumRounds = 200;
// A search is done when the quadratic promises less than this share of the cost, or, at an exact
// fit, less than this square per wavelength.
constexpr double kRelativeGain = 1e-8;
constexpr double kAbsoluteGain = 1e-18;
constexpr double kFirstDamping = 1e-3;
constexpr double kLeastDamping = 1e-12;
// A step shorter than this is lost in rounding.
constexpr double kMostDamping = 1e10;
// Added to the diagonal, as a share of its sum: what does not act on the spectrum stays in place.
constexpr double kRidge = 1e-14;

// Coordinates in [0, 1] about a point. Up to half the range of melanin they are the amounts of its
// two kinds, which act independently; beyond, where their sum may meet its bound, melanin and its
// blend.
class Chart {
 public:
  Chart(const ParameterVector& parameters, const ParameterAxes& axes) : axes_(axes) {
    for (int k = 0; k < kParameterCount; ++k) {
      x_[k] = parameters[k] / axes[static_cast<std::size_t>(k)].maximum;
    }
    blended_ = x_[kMelanin] > 0.5;
    if (blended_) return;
    const double melanin = x_[kMelanin], eumelanin = melanin * parameters[kMelaninBlend];
    x_[0] = eumelanin;
    x_[1] = std::max(0.0, melanin - eumelanin);
  }

  const EquationVector& x() const { return x_; }

  // From derivatives by amounts to derivatives by these coordinates.
  void turn(SpectralEquations& equations) const {
    if (!blended_) return;
    EquationMatrix by = EquationMatrix::Identity();
    const double range = axes_[kMelaninBlend].maximum;
    const double melanin = x_[kMelanin], blend = x_[kMelaninBlend] * range;
    by(0, 0) = blend;
    by(1, 0) = 1.0 - blend;
    by(0, 1) = melanin * range;
    by(1, 1) = -melanin * range;
    equations.hessian = by.transpose() * equations.hessian * by;
    equations.downhill = by.transpose() * equations.downhill;
  }

  ParameterVector moved(const EquationVector& step) const {
    EquationVector to = (x_ + step).cwiseMax(0.0).cwiseMin(1.0);
    if (!blended_) {
      const double melanin = to[0] + to[1];
      to[1] = melanin > 0.0 ? to[0] / melanin / axes_[kMelaninBlend].maximum : 0.0;
      to[0] = melanin;
    }
    ParameterVector parameters;
    for (int k = 0; k < kParameterCount; ++k) {
      parameters[k] = std::min(to[k], 1.0) * axes_[static_cast<std::size_t>(k)].maximum;
    }
    return parameters;
  }

 private:
  const ParameterAxes& axes_;
  EquationVector x_;
  bool blended_;
};

// One damped Gauss–Newton search.
class Search {
 public:
  Search(const double* measured, const ParameterVector& start)
      : measured_(measured), trial_(start) {}

  const double* measured() const { return measured_; }
  const ParameterVector& trial() const { return trial_; }
  const ParameterVector& parameters() const { return parameters_; }
  double cost() const { return cost_; }

  // Takes in what the trial came to and sets out for the next; false when there is none.
  bool advance(const SpectralEquations& atTrial, const SpectralMisfit& misfit) {
    if (atTrial.cost <= cost_) {
      const double gained = cost_ - atTrial.cost;
      damping_ *= gained > 0.75 * promised_ ? 0.1 : gained < 0.25 * promised_ ? 3.0 : 1.0;
      damping_ = std::max(damping_, kLeastDamping);
      parameters_ = trial_;
      cost_ = atTrial.cost;
      equations_ = atTrial;
      Chart(parameters_, misfit.axes()).turn(equations_);
      equations_.hessian.diagonal().array() += kRidge * equations_.hessian.trace();
    } else {
      damping_ *= 10.0;
    }
    if (++rounds_ > kMaximumRounds || damping_ > kMostDamping) return false;
    const Chart chart(parameters_, misfit.axes());
    const double enough =
        kRelativeGain * cost_ + kAbsoluteGain * static_cast<double>(misfit.wavelengthCount());
    const BoundedStep next = stepFrom(chart, damping_);
    // Damping shortens steps; only without it a small promise means that the end is reached.
    if (next.decrease <= enough && stepFrom(chart, 0.0).decrease <= enough) return false;
    promised_ = next.decrease;
    trial_ = chart.moved(next.step);
    return true;
  }

 private:
  BoundedStep stepFrom(const Chart& chart, double damping) const {
    EquationMatrix damped = equations_.hessian;
    damped.diagonal() *= 1.0 + damping;
    return boundedStep(damped, equations_.downhill, chart.x());
  }

  const double* measured_;
  ParameterVector trial_;
  ParameterVector parameters_ = ParameterVector::Zero();
  double cost_ = std::numeric_limits<double>::infinity();
  SpectralEquations equations_;  // in the chart of parameters_
  double damping_ = kFirstDamping;
  double promised_ = 0.0;
  int rounds_ = 0;
};

// Spectra spread over the box, one a column, to begin from the nearest.
class Starts {
 public:
  explicit Starts(const SpectralMisfit& misfit) : sets_(sampleBox(misfit.axes(), kSamples)) {
    std::stable_sort(sets_.begin(), sets_.end(),
                     [](const ParameterVector& a, const ParameterVector& b) {
                       return a[kHaemoglobinDermal] < b[kHaemoglobinDermal];
                     });
    const Eigen::MatrixXd spectra = misfit.spectra(sets_);
    stride_ = (spectra.rows() + kComparedWavelengths - 1) / kComparedWavelengths;
    spectra_ = spectra(Eigen::seq(0, Eigen::last, stride_), Eigen::all);
    squares_ = spectra_.colwise().squaredNorm();
  }

  // kStarts of them.
  void addNearest(const double* measured, std::vector<Search>& searches) const {
    using Strided = Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<>>;
    const Eigen::VectorXd spectrum =
        Strided(measured, spectra_.rows(), Eigen::InnerStride<>(stride_));
    const Eigen::VectorXd distance = squares_ - 2.0 * (spectra_.transpose() * spectrum);
    const auto nearer = [&](std::size_t a, std::size_t b) {
      const double ofA = distance[static_cast<Eigen::Index>(a)];
      const double ofB = distance[static_cast<Eigen::Index>(b)];
      return ofA != ofB ? ofA < ofB : a < b;
    };
    std::vector<std::size_t> sets(sets_.size() / kParts);
    for (std::size_t part = 0; part < kParts; ++part) {
      std::iota(sets.begin(), sets.end(), part * sets.size());
      std::partial_sort(sets.begin(), sets.begin() + kStartsPerPart, sets.end(), nearer);
      for (std::size_t s = 0; s < kStartsPerPart; ++s) {
        searches.emplace_back(measured, sets_[sets[s]]);
      }
    }
  }

 private:
  std::vector<ParameterVector> sets_;  // by dermal haemoglobin
  Eigen::Index stride_ = 1;            // from one compared wavelength to the next
  Eigen::MatrixXd spectra_;
  Eigen::VectorXd squares_;
};

// All searches together, so that the model is evaluated for many at once.
Status runSearches(const SpectralMisfit& misfit, std::vector<Search>& searches,
                   const JobContext& context) {
  std::vector<Search*> active;
  for (Search& search : searches)
    active.push_back(&search);
  std::vector<ParameterVector> sets;
  std::vector<const double*> measured;
  while (!active.empty()) {
    if (context.stopRequested()) return Cancelled{};
    sets.clear();
    measured.clear();
    for (const Search* search : active) {
      sets.push_back(search->trial());
      measured.push_back(search->measured());
    }
    const std::vector<SpectralEquations> equations = misfit.equations(sets, measured);
    std::size_t left = 0;
    for (std::size_t i = 0; i < active.size(); ++i) {
      if (active[i]->advance(equations[i], misfit)) active[left++] = active[i];
    }
    active.resize(left);
  }
  return {};
}

}  // namespace

Result<std::vector<SpectrumFit>> fitSpectra(const SkinModel& model,
                                            std::span<const double> wavelengthsNm,
                                            std::span<const double> reflectances,
                                            const JobContext& context,
                                            const MeasurementGeometry& geometry) {
  const SpectralMisfit misfit(model, wavelengthsNm, geometry.edgeLossPerMm);
  const Starts starts(misfit);
  const std::size_t width = wavelengthsNm.size();
  std::vector<double> modelled(reflectances.size());
  std::transform(reflectances.begin(), reflectances.end(), modelled.begin(),
                 [&](double measured) { return modelReflectance(geometry, measured); });
  std::vector<SpectrumFit> fits(reflectances.size() / width);
  const std::size_t pieces = (fits.size() + kSpectraPerPiece - 1) / kSpectraPerPiece;
  CUTIS_CHECK(parallelFor(pieces, context, [&](std::size_t piece) -> Status {
    const std::size_t first = piece * kSpectraPerPiece;
    const std::size_t last = std::min(first + kSpectraPerPiece, fits.size());
    std::vector<Search> searches;
    for (std::size_t i = first; i < last; ++i) {
      starts.addNearest(modelled.data() + i * width, searches);
    }
    CUTIS_CHECK(runSearches(misfit, searches, context));
    for (std::size_t i = first; i < last; ++i) {
      const auto own = searches.begin() + static_cast<std::ptrdiff_t>((i - first) * kStarts);
      const auto best = std::min_element(
          own, own + kStarts, [](const Search& a, const Search& b) { return a.cost() < b.cost(); });
      const double rmse = std::sqrt(best->cost() / static_cast<double>(width));
      fits[i] = {best->parameters(), geometry.enteringShare * rmse};
    }
    return {};
  }));
  return fits;
}

}  // namespace cutis
