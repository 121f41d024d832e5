#include "core/fit/spectra/spectra_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"
#include "core/maths/damped_search.h"
#include "core/skin/profile/parameter_sampling.h"

namespace cutis {
namespace {

// Points of the box that searches begin among.
constexpr int kSamples = 8192;
constexpr std::size_t kSpectraPerPiece = 16;
// Searches begin at samples of the box. Little blood in the dermis and much of it may fit a
// spectrum alike, with nothing lower between, so the nearest samples are taken from each of several
// parts of its range.
constexpr std::size_t kParts = 4;
constexpr std::size_t kStartsPerPart = 2;
constexpr std::size_t kStarts = kParts * kStartsPerPart;
// More wavelengths than this do not help to find the nearest.
constexpr Eigen::Index kComparedWavelengths = 32;
constexpr int kMaximumRounds = 200;
// A search is done when the quadratic promises less than this share of the cost, or, at an exact
// fit, less than this square per wavelength.
constexpr double kRelativeGain = 1e-8;
constexpr double kAbsoluteGain = 1e-18;
// Added to the diagonal, as a share of its sum: what does not act on the spectrum stays in place.
constexpr double kRidge = 1e-14;

// Coordinates in [0, 1] about a point. Up to half the range of melanin they are the amounts of its
// two kinds, which act independently; beyond, where their sum may meet its bound, melanin and its
// blend. What follows the five parameters is a coordinate already.
template <int N>
class SearchChart {
 public:
  using Vector = typename EquationsOf<N>::Vector;

  SearchChart(const SearchPoint<N>& parameters, const ParameterAxes& axes) : axes_(axes) {
    for (int k = 0; k < kParameterCount; ++k) {
      x_[k] = parameters[k] / axes[static_cast<std::size_t>(k)].maximum;
    }
    for (int k = kParameterCount; k < N; ++k)
      x_[k] = parameters[k];
    blended_ = x_[kMelanin] > 0.5;
    if (blended_) return;
    const double melanin = x_[kMelanin], eumelanin = melanin * parameters[kMelaninBlend];
    x_[0] = eumelanin;
    x_[1] = std::max(0.0, melanin - eumelanin);
  }

  const Vector& x() const { return x_; }

  // Turns derivatives by amounts into derivatives by these coordinates.
  void turn(EquationsOf<N>& equations) const {
    if (!blended_) return;
    typename EquationsOf<N>::Matrix by = EquationsOf<N>::Matrix::Identity();
    const double range = axes_[kMelaninBlend].maximum;
    const double melanin = x_[kMelanin], blend = x_[kMelaninBlend] * range;
    by(0, 0) = blend;
    by(1, 0) = 1.0 - blend;
    by(0, 1) = melanin * range;
    by(1, 1) = -melanin * range;
    equations.hessian = by.transpose() * equations.hessian * by;
    equations.downhill = by.transpose() * equations.downhill;
  }

  SearchPoint<N> moved(const Vector& step) const {
    Vector to = (x_ + step).cwiseMax(0.0).cwiseMin(1.0);
    if (!blended_) {
      const double melanin = to[0] + to[1];
      to[1] = melanin > 0.0 ? to[0] / melanin / axes_[kMelaninBlend].maximum : 0.0;
      to[0] = melanin;
    }
    SearchPoint<N> parameters;
    for (int k = 0; k < kParameterCount; ++k) {
      parameters[k] = std::min(to[k], 1.0) * axes_[static_cast<std::size_t>(k)].maximum;
    }
    for (int k = kParameterCount; k < N; ++k)
      parameters[k] = to[k];
    return parameters;
  }

 private:
  const ParameterAxes& axes_;
  Vector x_;
  bool blended_;
};

// One search.
template <int N>
class SpectrumSearch {
 public:
  SpectrumSearch(const double* measured, const SearchPoint<N>& start)
      : measured_(measured), trial_(start) {}

  const double* measured() const { return measured_; }
  const SearchPoint<N>& trial() const { return trial_; }
  const SearchPoint<N>& parameters() const { return parameters_; }
  double cost() const { return search_.cost(); }

  // Takes in what the trial came to and sets out for the next; false when there is none.
  bool advance(const EquationsOf<N>& atTrial, const ParameterAxes& axes,
               std::size_t wavelengthCount) {
    if (search_.improves(atTrial.cost)) {
      parameters_ = trial_;
      EquationsOf<N> turned = atTrial;
      SearchChart<N>(parameters_, axes).turn(turned);
      turned.hessian.diagonal().array() += kRidge * turned.hessian.trace();
      search_.accept(turned);
    } else {
      search_.reject();
    }
    const SearchChart<N> chart(parameters_, axes);
    const double enough =
        kRelativeGain * search_.cost() + kAbsoluteGain * static_cast<double>(wavelengthCount);
    typename EquationsOf<N>::Vector step;
    if (!search_.next(chart.x(), enough, step)) return false;
    trial_ = chart.moved(step);
    return true;
  }

 private:
  const double* measured_;
  SearchPoint<N> trial_;
  SearchPoint<N> parameters_ = SearchPoint<N>::Zero();
  DampedSearch<N> search_{{.maximumRounds = kMaximumRounds}};  // in the chart of parameters_
};

// Spectra spread over the box, one a column, to begin from the nearest.
template <int N>
class SearchStarts {
 public:
  // samples: of the box, in number a multiple of kParts.
  SearchStarts(const SpectraMisfit<N>& misfit, std::vector<SearchPoint<N>> samples)
      : sets_(std::move(samples)) {
    std::stable_sort(sets_.begin(), sets_.end(),
                     [](const SearchPoint<N>& a, const SearchPoint<N>& b) {
                       return a[kHaemoglobinDermal] < b[kHaemoglobinDermal];
                     });
    const Eigen::MatrixXd spectra = misfit.spectra(sets_);
    stride_ = (spectra.rows() + kComparedWavelengths - 1) / kComparedWavelengths;
    spectra_ = spectra(Eigen::seq(0, Eigen::last, stride_), Eigen::all);
    squares_ = spectra_.colwise().squaredNorm();
  }

  // kStarts of them.
  void addNearest(const double* measured, std::vector<SpectrumSearch<N>>& searches) const {
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
  std::vector<SearchPoint<N>> sets_;  // by dermal haemoglobin
  Eigen::Index stride_ = 1;           // from one compared wavelength to the next
  Eigen::MatrixXd spectra_;
  Eigen::VectorXd squares_;
};

template <int N>
Status runAll(const SpectraMisfit<N>& misfit, std::vector<SpectrumSearch<N>>& searches,
              const JobContext& context) {
  const auto evaluate = [&](const std::vector<SpectrumSearch<N>*>& active) {
    std::vector<SearchPoint<N>> sets;
    std::vector<const double*> measured;
    for (const SpectrumSearch<N>* search : active) {
      sets.push_back(search->trial());
      measured.push_back(search->measured());
    }
    return misfit.equations(sets, measured);
  };
  const auto advance = [&](SpectrumSearch<N>& search, const EquationsOf<N>& equations) {
    return search.advance(equations, misfit.axes(), misfit.wavelengthCount());
  };
  if (!runSearches(searches, evaluate, advance, [&] { return context.stopRequested(); })) {
    return Cancelled{};
  }
  return {};
}

}  // namespace

template <int N>
std::vector<SearchPoint<N>> searchSamples(const ParameterAxes& axes) {
  const std::vector<ParameterVector> sets = sampleBox(axes, kSamples);
  std::vector<SearchPoint<N>> samples(sets.size());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    samples[i].template head<kParameterCount>() = sets[i];
    for (int k = kParameterCount; k < N; ++k)
      samples[i][k] = samplePlace(k - kParameterCount, static_cast<int>(i));
  }
  return samples;
}

template <int N>
Result<std::vector<FoundPoint<N>>> searchSpectra(const SpectraMisfit<N>& misfit,
                                                 std::vector<SearchPoint<N>> samples,
                                                 std::span<const SearchPoint<N>> known,
                                                 std::span<const double> reflectances,
                                                 const JobContext& context) {
  using Search = SpectrumSearch<N>;
  const SearchStarts<N> starts(misfit, std::move(samples));
  const std::size_t startCount = kStarts + (known.empty() ? 0 : 1);
  const std::size_t width = misfit.wavelengthCount();
  std::vector<FoundPoint<N>> found(reflectances.size() / width);
  const std::size_t pieces = (found.size() + kSpectraPerPiece - 1) / kSpectraPerPiece;
  CUTIS_CHECK(parallelFor(pieces, context, [&](std::size_t piece) -> Status {
    const std::size_t first = piece * kSpectraPerPiece;
    const std::size_t last = std::min(first + kSpectraPerPiece, found.size());
    std::vector<Search> searches;
    for (std::size_t i = first; i < last; ++i) {
      starts.addNearest(reflectances.data() + i * width, searches);
      if (!known.empty()) searches.emplace_back(reflectances.data() + i * width, known[i]);
    }
    CUTIS_CHECK(runAll(misfit, searches, context));
    for (std::size_t i = first; i < last; ++i) {
      const auto own = searches.begin() + static_cast<std::ptrdiff_t>((i - first) * startCount);
      const auto best =
          std::min_element(own, own + static_cast<std::ptrdiff_t>(startCount),
                           [](const Search& a, const Search& b) { return a.cost() < b.cost(); });
      found[i] = {best->parameters(), std::sqrt(best->cost() / static_cast<double>(width))};
    }
    return {};
  }));
  return found;
}

template std::vector<SearchPoint<kParameterCount>> searchSamples<kParameterCount>(
    const ParameterAxes&);
template Result<std::vector<FoundPoint<kParameterCount>>> searchSpectra(
    const SpectraMisfit<kParameterCount>&, std::vector<SearchPoint<kParameterCount>>,
    std::span<const SearchPoint<kParameterCount>>, std::span<const double>, const JobContext&);
template std::vector<SearchPoint<kParameterCount + 1>> searchSamples<kParameterCount + 1>(
    const ParameterAxes&);
template Result<std::vector<FoundPoint<kParameterCount + 1>>> searchSpectra(
    const SpectraMisfit<kParameterCount + 1>&, std::vector<SearchPoint<kParameterCount + 1>>,
    std::span<const SearchPoint<kParameterCount + 1>>, std::span<const double>, const JobContext&);
template std::vector<SearchPoint<kParameterCount + 2>> searchSamples<kParameterCount + 2>(
    const ParameterAxes&);
template Result<std::vector<FoundPoint<kParameterCount + 2>>> searchSpectra(
    const SpectraMisfit<kParameterCount + 2>&, std::vector<SearchPoint<kParameterCount + 2>>,
    std::span<const SearchPoint<kParameterCount + 2>>, std::span<const double>, const JobContext&);

}  // namespace cutis
