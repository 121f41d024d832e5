#include "core/spectra/spectral_curve.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace cutis {

Spectrum resample(const SpectralCurve& curve) {
  const std::vector<double>& nm = curve.wavelengthsNm;
  assert(!nm.empty() && nm.size() == curve.values.size());
  Spectrum spectrum = Spectrum::Zero();
  for (int i = 0; i < kSampleCount; ++i) {
    const double at = wavelengthNm(i);
    if (at < nm.front() || at > nm.back()) continue;
    const auto above = std::lower_bound(nm.begin(), nm.end(), at);
    const auto k = static_cast<std::size_t>(above - nm.begin());
    if (*above == at) {
      spectrum[i] = curve.values[k];
      continue;
    }
    const double share = (at - nm[k - 1]) / (nm[k] - nm[k - 1]);
    spectrum[i] = curve.values[k - 1] + share * (curve.values[k] - curve.values[k - 1]);
  }
  return spectrum;
}

}  // namespace cutis
