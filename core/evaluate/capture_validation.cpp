#include "core/evaluate/capture_validation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>

#include "core/base/parallel.h"
#include "core/base/pixel_rows.h"
#include "core/base/random.h"
#include "core/fit/refined/refined_solver.h"
#include "core/fit/spectrum_posterior.h"
#include "core/simulate/counter_normal.h"

namespace cutis {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kPhotographsPerPiece = 16;
constexpr double kDeviationsHeld = 2.0;

double between(const Spectrum& spectrum, double wavelength) {
  const double position = (wavelength - kFirstWavelengthNm) / kWavelengthStepNm;
  const int below = std::clamp(static_cast<int>(position), 0, kSampleCount - 2);
  const double share = position - below;
  return (1.0 - share) * spectrum[below] + share * spectrum[below + 1];
}

// [first, last) of the wavelengths within the range.
struct Part {
  std::size_t first = 0, last = 0;
};
Part partOf(const MeasuredSpectra& spectra, const WavelengthRange& range) {
  const std::vector<double>& nm = spectra.wavelengthsNm;
  const auto first = std::lower_bound(nm.begin(), nm.end(), range.fromNm);
  const auto last = std::upper_bound(nm.begin(), nm.end(), range.toNm);
  return {static_cast<std::size_t>(first - nm.begin()),
          static_cast<std::size_t>(std::max(first, last) - nm.begin())};
}

double errorAt(const MeasuredSpectra& spectra, const EstimatedSpectra& estimated,
               std::size_t wavelength, std::size_t spectrum) {
  return estimated.reflectance(static_cast<Eigen::Index>(wavelength),
                               static_cast<Eigen::Index>(spectrum)) -
         spectrumAt(spectra, spectrum)[wavelength];
}

// The RMSE of each person; none if one of them has an error that is not known.
std::vector<double> errorsOfPeople(const Part& part, const MeasuredSpectra& spectra,
                                   const EstimatedSpectra& estimated,
                                   std::span<const std::vector<std::size_t>> people) {
  std::vector<double> errors;
  for (const std::vector<std::size_t>& person : people) {
    double squares = 0.0;
    for (const std::size_t spectrum : person) {
      for (std::size_t w = part.first; w < part.last; ++w)
        squares += std::pow(errorAt(spectra, estimated, w, spectrum), 2);
    }
    errors.push_back(
        std::sqrt(squares / static_cast<double>(person.size() * (part.last - part.first))));
    if (!std::isfinite(errors.back())) return {};
  }
  return errors;
}

double shareHeld(const Part& part, const MeasuredSpectra& spectra,
                 const EstimatedSpectra& estimated,
                 std::span<const std::vector<std::size_t>> people) {
  if (estimated.deviation.size() == 0) return kUnknown;
  std::size_t held = 0, all = 0;
  for (const std::vector<std::size_t>& person : people) {
    for (const std::size_t spectrum : person) {
      for (std::size_t w = part.first; w < part.last; ++w) {
        const double deviation =
            estimated.deviation(static_cast<Eigen::Index>(w), static_cast<Eigen::Index>(spectrum));
        const double error = std::abs(errorAt(spectra, estimated, w, spectrum));
        held += error <= kDeviationsHeld * deviation ? 1 : 0;
        ++all;
      }
    }
  }
  return static_cast<double>(held) / static_cast<double>(all);
}

double meanOver(const Part& part, const MeasuredSpectra& spectra,
                const std::vector<std::size_t>& person) {
  double sum = 0.0;
  for (const std::size_t spectrum : person) {
    const auto values = spectrumAt(spectra, spectrum).subspan(part.first, part.last - part.first);
    sum += std::accumulate(values.begin(), values.end(), 0.0);
  }
  return sum / static_cast<double>(person.size() * (part.last - part.first));
}

}  // namespace

Rig rigWithin(const Rig& rig, const WavelengthRange& range) {
  Rig within = rig;
  const Band band = bandBetween(range.fromNm, range.toNm);
  for (RigLight& light : within.lights) {
    light.power.head(band.first) = 0.0;
    light.power.tail(kSampleCount - 1 - band.last) = 0.0;
  }
  return within;
}

Eigen::MatrixXd photographSpectra(const Rig& rig, const MeasuredSpectra& spectra,
                                  const MeasurementGeometry& geometry, double noise,
                                  std::uint64_t key) {
  const SpectrumRows rows = responseRows(rig);
  Eigen::MatrixXd channels(rows.rows(), static_cast<Eigen::Index>(spectra.ids.size()));
  std::uint64_t counter = 0;
  for (std::size_t i = 0; i < spectra.ids.size(); ++i) {
    const Spectrum skin = (onGrid(spectra, i) - geometry.specularShare) / geometry.enteringShare;
    const auto column = static_cast<Eigen::Index>(i);
    channels.col(column) = rows.matrix() * skin.matrix();
    for (double& channel : channels.col(column)) {
      if (noise > 0.0) channel *= 1.0 + noise * double{normalAt(mixBits(key), counter++)};
      channel = std::max(channel, 0.0);
    }
  }
  return channels;
}

Eigen::MatrixXd resampled(const MeasuredSpectra& spectra, std::span<const double> wavelengthsNm) {
  const std::vector<double>& measured = spectra.wavelengthsNm;
  Eigen::MatrixXd values(static_cast<Eigen::Index>(wavelengthsNm.size()),
                         static_cast<Eigen::Index>(spectra.ids.size()));
  for (std::size_t w = 0; w < wavelengthsNm.size(); ++w) {
    const double nm = wavelengthsNm[w];
    const auto row = static_cast<Eigen::Index>(w);
    if (nm < measured.front() || nm > measured.back()) {
      values.row(row).setConstant(kUnknown);
      continue;
    }
    const auto next = std::upper_bound(measured.begin() + 1, measured.end() - 1, nm);
    const auto above = static_cast<std::size_t>(next - measured.begin());
    const double share = (nm - measured[above - 1]) / (measured[above] - measured[above - 1]);
    for (std::size_t i = 0; i < spectra.ids.size(); ++i) {
      const std::span<const double> spectrum = spectrumAt(spectra, i);
      values(row, static_cast<Eigen::Index>(i)) =
          (1.0 - share) * spectrum[above - 1] + share * spectrum[above];
    }
  }
  return values;
}

Result<EstimatedSpectra> fitPhotographs(const std::shared_ptr<const SkinModel>& model,
                                        const Rig& rig, const FitOptions& options,
                                        const Eigen::MatrixXd& channels,
                                        std::span<const std::size_t> spectra,
                                        const MeasurementGeometry& geometry,
                                        std::span<const double> wavelengthsNm,
                                        const JobContext& context) {
  const auto solver = makeRefinedSolver(model, rig, options);
  const SpectrumPosterior posterior(*model, rig, options);
  const auto wavelengths = static_cast<Eigen::Index>(wavelengthsNm.size());
  EstimatedSpectra estimated;
  estimated.reflectance = Eigen::MatrixXd::Constant(wavelengths, channels.cols(), kUnknown);
  estimated.deviation = estimated.reflectance;
  const auto fitPiece = [&](std::span<const std::size_t> piece) {
    PixelBuffer<float> pixels(static_cast<std::size_t>(channels.rows()), piece.size());
    PixelBuffer<float> values(solver->valueCount(), piece.size());
    std::vector<PixelState> states(piece.size());
    std::vector<std::uint16_t> iterations(piece.size());
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (std::size_t k = 0; k < pixels.rowCount(); ++k) {
        pixels[k][i] = static_cast<float>(
            channels(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(piece[i])));
      }
    }
    solver->solve(pixels.rows(), values.rows(), {states.data(), iterations.data()});
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(piece[i]);
      const Eigen::VectorXd seen = channels.col(column);
      std::vector<double> found;
      for (std::size_t k = 0; k < values.rowCount(); ++k)
        found.push_back(double{values[k][i]});
      const Spectrum reflectance = posterior.reflectance(found);
      const Spectrum deviation =
          posterior.deviation({seen.data(), static_cast<std::size_t>(seen.size())}, found);
      for (Eigen::Index w = 0; w < wavelengths; ++w) {
        const double nm = wavelengthsNm[static_cast<std::size_t>(w)];
        estimated.reflectance(w, column) = measuredReflectance(geometry, between(reflectance, nm));
        estimated.deviation(w, column) = geometry.enteringShare * between(deviation, nm);
      }
    }
  };
  const std::size_t pieces = (spectra.size() + kPhotographsPerPiece - 1) / kPhotographsPerPiece;
  CUTIS_CHECK(parallelFor(pieces, context, [&](std::size_t piece) -> Status {
    const std::size_t first = piece * kPhotographsPerPiece;
    fitPiece(spectra.subspan(first, std::min(kPhotographsPerPiece, spectra.size() - first)));
    return {};
  }));
  return estimated;
}

std::vector<std::vector<std::size_t>> peopleOf(const MeasuredSpectra& spectra) {
  std::map<std::string, std::size_t> known;
  std::vector<std::vector<std::size_t>> people;
  for (std::size_t i = 0; i < spectra.ids.size(); ++i) {
    const auto [at, isNew] = known.try_emplace(spectra.ids[i], people.size());
    if (isNew) people.emplace_back();
    people[at->second].push_back(i);
  }
  return people;
}

std::vector<std::size_t> toneThirdsOf(const MeasuredSpectra& spectra,
                                      std::span<const std::vector<std::size_t>> people) {
  const Part visible = partOf(spectra, kFittedRange);
  std::vector<double> lightness;
  for (const std::vector<std::size_t>& person : people)
    lightness.push_back(meanOver(visible, spectra, person));
  std::vector<std::size_t> order(people.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return lightness[a] < lightness[b]; });
  // As byTone() of validation.cpp: third t begins at the place count · t / kToneThirds.
  std::vector<std::size_t> thirds(people.size());
  for (std::size_t t = 0; t < kToneThirds; ++t) {
    for (std::size_t i = order.size() * t / kToneThirds; i < order.size() * (t + 1) / kToneThirds;
         ++i)
      thirds[order[i]] = t;
  }
  return thirds;
}

CaptureFigures::CaptureFigures()
    : median(kUnknown), within95(kUnknown), worst(kUnknown), coverage(kUnknown) {}

CaptureFigures captureFigures(const WavelengthRange& range, const MeasuredSpectra& spectra,
                              const EstimatedSpectra& estimated,
                              std::span<const std::vector<std::size_t>> people) {
  CaptureFigures figures;
  const bool isFitted = range.fromNm == kFittedRange.fromNm && range.toNm == kFittedRange.toNm;
  if (!isFitted && !measuredPart(spectra, range)) return figures;
  const Part part = partOf(spectra, range);
  if (part.first == part.last) return figures;
  const std::vector<double> errors = errorsOfPeople(part, spectra, estimated, people);
  if (errors.empty()) return figures;
  const ErrorDistribution distribution = distributionOf(errors);
  figures.median = distribution.median;
  figures.within95 = distribution.within95;
  figures.worst = distribution.most;
  figures.coverage = shareHeld(part, spectra, estimated, people);
  return figures;
}

std::vector<double> medianErrors(const MeasuredSpectra& spectra, const EstimatedSpectra& estimated,
                                 std::span<const std::vector<std::size_t>> people) {
  std::vector<double> medians;
  for (std::size_t w = 0; w < spectra.wavelengthsNm.size(); ++w)
    medians.push_back(
        distributionOf(errorsOfPeople({w, w + 1}, spectra, estimated, people)).median);
  return medians;
}

}  // namespace cutis
