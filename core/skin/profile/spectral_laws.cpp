#include "core/skin/profile/spectral_laws.h"

#include <algorithm>
#include <cmath>

namespace cutis {
namespace {

template <typename Formula>
Spectrum sampled(const Formula& formula) {
  Spectrum spectrum;
  for (int i = 0; i < kSampleCount; ++i) {
    spectrum[i] = formula(wavelengthNm(i));
  }
  return spectrum;
}

double gaussian(double distance, double deviation) {
  const double ratio = distance / deviation;
  return std::exp(-0.5 * ratio * ratio);
}

// Weights of the samples 0, 1, … steps away.
Spectrum weightsByDistance(double deviationNm) {
  Spectrum weights;
  for (int i = 0; i < kSampleCount; ++i) {
    weights[i] = gaussian(double{kWavelengthStepNm} * i, deviationNm);
  }
  return weights;
}

double interpolated(const Spectrum& spectrum, double position) {
  const double inside = std::clamp(position, 0.0, kSampleCount - 1.0);
  const int below = std::min(static_cast<int>(inside), kSampleCount - 2);
  const double share = inside - below;
  return (1.0 - share) * spectrum[below] + share * spectrum[below + 1];
}

}  // namespace

Spectrum onGrid(const PowerLaw& law) {
  return sampled(
      [&](double nm) { return law.coefficient * std::pow(nm / law.referenceNm, law.exponent); });
}

Spectrum onGrid(const ExponentialTail& tail) {
  return sampled([&](double nm) {
    const double beyond = nm - tail.originNm;
    return tail.amplitude * std::exp(-beyond / tail.decayNm);
  });
}

Spectrum onGrid(const GaussianBand& band) {
  return sampled(
      [&](double nm) { return band.peak * gaussian(nm - band.centreNm, band.deviationNm); });
}

Spectrum smoothed(const Spectrum& spectrum, double deviationNm) {
  if (deviationNm == 0.0) return spectrum;
  const Spectrum weights = weightsByDistance(deviationNm);
  Spectrum result;
  for (int i = 0; i < kSampleCount; ++i) {
    double sum = 0.0, total = 0.0;
    for (int k = 0; k < kSampleCount; ++k) {
      const double weight = weights[std::abs(k - i)];
      sum += weight * spectrum[k];
      total += weight;
    }
    result[i] = sum / total;
  }
  return result;
}

Spectrum shiftedAndSmoothed(const Spectrum& spectrum, double shiftNm, double deviationNm) {
  if (shiftNm == 0.0 && deviationNm == 0.0) return spectrum;
  const double steps = shiftNm / kWavelengthStepNm;
  Spectrum moved;
  for (int i = 0; i < kSampleCount; ++i) {
    moved[i] = interpolated(spectrum, i - steps);
  }
  if (deviationNm == 0.0) return moved;
  const Spectrum weights = weightsByDistance(deviationNm);
  Spectrum result;
  for (int i = 0; i < kSampleCount; ++i) {
    double sum = 0.0, total = 0.0;
    for (int offset = 1 - kSampleCount; offset < kSampleCount; ++offset) {
      const double weight = weights[std::abs(offset)];
      sum += weight * interpolated(spectrum, i + offset - steps);
      total += weight;
    }
    result[i] = sum / total;
  }
  return result;
}

}  // namespace cutis
