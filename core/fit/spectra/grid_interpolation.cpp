#include "core/fit/spectra/grid_interpolation.h"

#include <algorithm>
#include <cmath>

#include "core/spectra/grid.h"

namespace cutis {
namespace {

// The last grid sample that is not above a wavelength, and how far it is on the way to the next.
int sampleBelow(double wavelengthNm) {
  const double position = (wavelengthNm - kFirstWavelengthNm) / kWavelengthStepNm;
  return std::clamp(static_cast<int>(std::floor(position)), 0, kSampleCount - 1);
}

double shareAbove(double wavelengthNm) {
  const double position = (wavelengthNm - kFirstWavelengthNm) / kWavelengthStepNm;
  return position - sampleBelow(wavelengthNm);
}

}  // namespace

GridInterpolation gridInterpolation(std::span<const double> wavelengthsNm) {
  GridInterpolation measured;
  std::vector<int>& samples = measured.samples;
  for (const double wavelength : wavelengthsNm) {
    samples.push_back(sampleBelow(wavelength));
    if (shareAbove(wavelength) > 0.0) samples.push_back(samples.back() + 1);
  }
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  for (const double wavelength : wavelengthsNm) {
    InterpolatedRow row;
    const auto at = std::lower_bound(samples.begin(), samples.end(), sampleBelow(wavelength));
    row.lower = static_cast<std::size_t>(at - samples.begin());
    row.share = shareAbove(wavelength);
    row.upper = row.share > 0.0 ? row.lower + 1 : row.lower;
    measured.rows.push_back(row);
  }
  return measured;
}

Eigen::MatrixXd interpolated(const std::vector<InterpolatedRow>& rows,
                             const std::vector<double>& values, std::size_t count) {
  Eigen::MatrixXd spectra(rows.size(), count);
  for (std::size_t w = 0; w < rows.size(); ++w) {
    const InterpolatedRow& row = rows[w];
    for (std::size_t i = 0; i < count; ++i) {
      spectra(static_cast<Eigen::Index>(w), static_cast<Eigen::Index>(i)) =
          (1.0 - row.share) * values[row.lower * count + i] +
          row.share * values[row.upper * count + i];
    }
  }
  return spectra;
}

}  // namespace cutis
