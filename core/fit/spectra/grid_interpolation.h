#pragma once  // internal to core/fit/spectra

// Measured wavelengths among the samples of the grid: each lies at a sample or between two, where
// the model is interpolated linearly. Thread-safe: pure functions.

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace cutis {

// A wavelength between two of the samples, or at one (both the same).
struct InterpolatedRow {
  std::size_t lower = 0;
  std::size_t upper = 0;
  double share = 0.0;  // of the upper
};

struct GridInterpolation {
  std::vector<int> samples;           // positions on the grid that are needed, increasing
  std::vector<InterpolatedRow> rows;  // one a wavelength; lower and upper count in `samples`
};

// wavelengthsNm: increasing, within the grid.
GridInterpolation gridInterpolation(std::span<const double> wavelengthsNm);

// Spectra at the measured wavelengths, one a column, of values at the samples: [sample][spectrum].
Eigen::MatrixXd interpolated(const std::vector<InterpolatedRow>& rows,
                             const std::vector<double>& values, std::size_t count);

}  // namespace cutis
