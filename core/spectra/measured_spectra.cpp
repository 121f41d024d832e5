#include "core/spectra/measured_spectra.h"

#include <algorithm>

namespace cutis {

std::span<const double> spectrumAt(const MeasuredSpectra& spectra, std::size_t index) {
  const std::size_t width = spectra.wavelengthsNm.size();
  return std::span(spectra.reflectances).subspan(index * width, width);
}

Spectrum onGrid(const MeasuredSpectra& spectra, std::size_t index) {
  const std::vector<double>& wavelengths = spectra.wavelengthsNm;
  const std::span<const double> measured = spectrumAt(spectra, index);
  Spectrum values;
  for (int sample = 0; sample < kSampleCount; ++sample) {
    const double wavelength = wavelengthNm(sample);
    const auto next = std::upper_bound(wavelengths.begin() + 1, wavelengths.end() - 1, wavelength);
    const auto above = static_cast<std::size_t>(next - wavelengths.begin());
    const double share =
        (wavelength - wavelengths[above - 1]) / (wavelengths[above] - wavelengths[above - 1]);
    values[sample] = (1.0 - share) * measured[above - 1] + share * measured[above];
  }
  return values;
}

MeasuredSpectra selected(const MeasuredSpectra& spectra, std::span<const std::size_t> indices) {
  MeasuredSpectra some;
  some.wavelengthsNm = spectra.wavelengthsNm;
  for (const std::size_t index : indices) {
    some.ids.push_back(spectra.ids[index]);
    const std::span<const double> values = spectrumAt(spectra, index);
    some.reflectances.insert(some.reflectances.end(), values.begin(), values.end());
  }
  return some;
}

}  // namespace cutis
