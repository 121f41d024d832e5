#pragma once

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

// From values [sample][spectrum] at `samples`, one spectrum a column at the wavelengths.
Eigen::MatrixXd interpolated(const GridInterpolation& grid, const std::vector<double>& values,
                             std::size_t count);

// wavelengthsNm: increasing, within the grid.
GridInterpolation gridInterpolation(std::span<const double> wavelengthsNm);

}  // namespace cutis
