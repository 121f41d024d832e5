#include "core/evaluate/validation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "core/base/parallel.h"
#include "core/fit/reference/map_estimator.h"
#include "core/fit/spectra/spectra_fit.h"
#include "core/skin/model/choose_nodes.h"
#include "core/skin/model/instrument_model.h"

namespace cutis {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kSpectraPerPiece = 16;

std::size_t countOf(const MeasuredSpectra& spectra) {
  return spectra.ids.size();
}

// Linear between the samples of the grid.
double at(const Spectrum& spectrum, double wavelength) {
  const double position = (wavelength - kFirstWavelengthNm) / kWavelengthStepNm;
  const int below = std::clamp(static_cast<int>(position), 0, kSampleCount - 2);
  const double share = position - below;
  return (1.0 - share) * spectrum[below] + share * spectrum[below + 1];
}

// One row of modelled − measured per spectrum, [spectrum][wavelength].
using Residuals = std::vector<double>;

Status addResiduals(const InstrumentModel& model, const MeasuredSpectra& spectra, std::size_t index,
                    const ParameterVector& parameters, Residuals& residuals) {
  const Spectrum modelled = model.reflectance(parameters);
  const std::span<const double> measured = spectrumAt(spectra, index);
  for (std::size_t w = 0; w < measured.size(); ++w) {
    residuals[index * measured.size() + w] = at(modelled, spectra.wavelengthsNm[w]) - measured[w];
  }
  return {};
}

ErrorDistribution errorsOver(const WavelengthRange& range, const MeasuredSpectra& spectra,
                             const Residuals& residuals) {
  const std::size_t width = spectra.wavelengthsNm.size();
  std::vector<double> errors;
  for (std::size_t i = 0; i < countOf(spectra); ++i) {
    double sum = 0.0, count = 0.0;
    for (std::size_t w = 0; w < width; ++w) {
      if (!range.contains(spectra.wavelengthsNm[w])) continue;
      sum += residuals[i * width + w] * residuals[i * width + w];
      count += 1.0;
    }
    errors.push_back(std::sqrt(sum / count));
  }
  return distributionOf(std::move(errors));
}

// The visible part, and the parameters that come closest to it.
Result<std::vector<ParameterVector>> fitVisible(const SkinModel& model,
                                                const MeasuredSpectra& spectra,
                                                const MeasurementGeometry& geometry,
                                                const JobContext& context) {
  std::vector<double> wavelengths, reflectances;
  for (const double wavelength : spectra.wavelengthsNm) {
    if (kFittedRange.contains(wavelength)) wavelengths.push_back(wavelength);
  }
  for (std::size_t i = 0; i < spectra.reflectances.size(); ++i) {
    const double wavelength = spectra.wavelengthsNm[i % spectra.wavelengthsNm.size()];
    if (kFittedRange.contains(wavelength)) reflectances.push_back(spectra.reflectances[i]);
  }
  CUTIS_TRY(fits, fitSpectra(model, wavelengths, reflectances, context, geometry));
  std::vector<ParameterVector> parameters;
  for (const SpectrumFit& fit : fits)
    parameters.push_back(fit.parameters);
  return parameters;
}

// Parameters of every spectrum → residuals.
Result<Residuals> residualsOf(const InstrumentModel& model, const MeasuredSpectra& spectra,
                              const std::vector<ParameterVector>& parameters,
                              const JobContext& context) {
  Residuals residuals(spectra.reflectances.size());
  CUTIS_CHECK(parallelFor(parameters.size(), context, [&](std::size_t i) {
    return addResiduals(model, spectra, i, parameters[i], residuals);
  }));
  return residuals;
}

// The rig's channels over the wavelengths that were measured; each sums to 1.
SpectrumRows channelsWithin(const MeasuredSpectra& spectra, const Rig& rig) {
  SpectrumRows rows = responseRows(rig);
  const Band band = bandBetween(spectra.wavelengthsNm.front(), spectra.wavelengthsNm.back());
  rows.leftCols(band.first) = 0.0;
  rows.rightCols(kSampleCount - 1 - band.last) = 0.0;
  for (Eigen::Index k = 0; k < rows.rows(); ++k)
    rows.row(k) /= rows.row(k).sum();
  return rows;
}

Result<std::vector<ParameterVector>> fitColors(const SkinModel& model,
                                               const MeasuredSpectra& spectra,
                                               const MeasurementGeometry& geometry, const Rig& rig,
                                               const JobContext& context) {
  EstimatorOptions options;
  options.prior = model.profile().prior;
  options.noise = rig.noise;
  options.geometry = geometry;
  const SpectrumRows channels = channelsWithin(spectra, rig);
  const MapEstimator estimator(model, chooseNodes(model, channels), options);
  std::vector<ParameterVector> parameters(countOf(spectra));
  const std::size_t pieces = (parameters.size() + kSpectraPerPiece - 1) / kSpectraPerPiece;
  CUTIS_CHECK(parallelFor(pieces, context, [&](std::size_t piece) -> Status {
    const std::size_t first = piece * kSpectraPerPiece;
    const std::size_t last = std::min(first + kSpectraPerPiece, parameters.size());
    for (std::size_t i = first; i < last; ++i) {
      const Spectrum spectrum = onGrid(spectra, i);
      parameters[i] = estimator.solve(channels.matrix() * spectrum.matrix()).parameters;
    }
    return {};
  }));
  return parameters;
}

bool reachesOverTheVisible(const MeasuredSpectra& spectra) {
  return spectra.wavelengthsNm.front() <= kFittedRange.fromNm &&
         spectra.wavelengthsNm.back() >= kFittedRange.toNm;
}

double meanVisible(const MeasuredSpectra& spectra, std::size_t index) {
  const std::span<const double> spectrum = spectrumAt(spectra, index);
  double sum = 0.0, count = 0.0;
  for (std::size_t w = 0; w < spectrum.size(); ++w) {
    if (!kFittedRange.contains(spectra.wavelengthsNm[w])) continue;
    sum += spectrum[w];
    count += 1.0;
  }
  return sum / count;
}

void summarise(std::span<const std::size_t> members, std::size_t width, const Residuals& residuals,
               ToneResiduals& tone) {
  tone.spectra = members.size();
  if (members.empty()) return;
  const auto count = static_cast<double>(members.size());
  for (std::size_t w = 0; w < width; ++w) {
    double sum = 0.0, squares = 0.0;
    for (const std::size_t i : members)
      sum += residuals[i * width + w];
    const double mean = sum / count;
    for (const std::size_t i : members)
      squares += std::pow(residuals[i * width + w] - mean, 2);
    tone.mean.push_back(mean);
    tone.deviation.push_back(std::sqrt(squares / std::max(count - 1.0, 1.0)));
  }
}

std::array<ToneResiduals, kToneThirds> byTone(const MeasuredSpectra& spectra,
                                              const Residuals& residuals) {
  std::vector<double> lightness;
  for (std::size_t i = 0; i < countOf(spectra); ++i)
    lightness.push_back(meanVisible(spectra, i));
  std::vector<std::size_t> order(lightness.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return lightness[a] < lightness[b]; });
  std::array<ToneResiduals, kToneThirds> tones;
  for (std::size_t t = 0; t < tones.size(); ++t) {
    const std::size_t first = order.size() * t / tones.size();
    const std::size_t last = order.size() * (t + 1) / tones.size();
    const auto members = std::span(order).subspan(first, last - first);
    summarise(members, spectra.wavelengthsNm.size(), residuals, tones[t]);
    if (members.empty()) continue;
    tones[t].darkest = lightness[members.front()];
    tones[t].lightest = lightness[members.back()];
  }
  return tones;
}

}  // namespace

ErrorDistribution::ErrorDistribution() : mean(kNone), median(kNone), within95(kNone), most(kNone) {}

ErrorDistribution distributionOf(std::vector<double> errors) {
  ErrorDistribution distribution;
  if (errors.empty()) return distribution;
  std::sort(errors.begin(), errors.end());
  const std::size_t count = errors.size();
  distribution.mean =
      std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(count);
  distribution.median = 0.5 * (errors[(count - 1) / 2] + errors[count / 2]);
  distribution.within95 = errors[(count * 95 + 99) / 100 - 1];
  distribution.most = errors.back();
  return distribution;
}

std::optional<WavelengthRange> measuredPart(const MeasuredSpectra& spectra,
                                            const WavelengthRange& range) {
  std::optional<WavelengthRange> part;
  bool predicted = false;
  for (const double wavelength : spectra.wavelengthsNm) {
    if (!range.contains(wavelength)) continue;
    part = {part ? part->fromNm : wavelength, wavelength};
    predicted = predicted || !kFittedRange.contains(wavelength);
  }
  return predicted ? part : std::nullopt;
}

Result<ValidationFigures> validateModel(const SkinModel& model, const MeasuredSpectra& spectra,
                                        const MeasurementGeometry& geometry, const Rig& rig,
                                        const JobContext& context) {
  const InstrumentModel measured(model, geometry);
  const JobContext silent = {context.stop, {}, {}};
  CUTIS_TRY(fits, fitVisible(model, spectra, geometry, context.child(0.0, 0.6)));
  CUTIS_TRY(residuals, residualsOf(measured, spectra, fits, silent));
  ValidationFigures figures;
  figures.fitted = errorsOver(kFittedRange, spectra, residuals);
  if (measuredPart(spectra, kUltravioletRange)) {
    figures.ultraviolet = errorsOver(kUltravioletRange, spectra, residuals);
  }
  if (measuredPart(spectra, kNearInfraredRange)) {
    figures.nearInfrared = errorsOver(kNearInfraredRange, spectra, residuals);
  }
  figures.tones = byTone(spectra, residuals);
  if (!reachesOverTheVisible(spectra)) return figures;
  CUTIS_TRY(colors, fitColors(model, spectra, geometry, rig, context.child(0.6, 1.0)));
  CUTIS_TRY(predicted, residualsOf(measured, spectra, colors, silent));
  figures.fromColor = errorsOver(kFittedRange, spectra, predicted);
  return figures;
}

}  // namespace cutis
