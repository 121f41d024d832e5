#pragma once

// The wavelength grid of the program: 300–1000 nm in steps of 2 nm, both ends included. Every
// spectrum lives on it and every integral is a plain sum over it.

#include <Eigen/Core>

namespace cutis {

inline constexpr int kFirstWavelengthNm = 300;
inline constexpr int kLastWavelengthNm = 1000;
inline constexpr int kWavelengthStepNm = 2;
inline constexpr int kSampleCount =
    (kLastWavelengthNm - kFirstWavelengthNm) / kWavelengthStepNm + 1;
static_assert(kSampleCount == 351);

constexpr double wavelengthNm(int sample) {
  return kFirstWavelengthNm + kWavelengthStepNm * sample;
}

// One value per grid sample; what the value means (reflectance, power, absorption per mm) is said
// by the name of the variable.
using Spectrum = Eigen::Array<double, kSampleCount, 1>;

// Rows of spectra, such as the responses of several channels.
using SpectrumRows = Eigen::Array<double, Eigen::Dynamic, kSampleCount, Eigen::RowMajor>;

// Samples [first, last] of the grid, both ends included.
struct Band {
  int first = 0;
  int last = kSampleCount - 1;

  int count() const { return last - first + 1; }
  bool contains(int sample) const { return sample >= first && sample <= last; }
  bool operator==(const Band&) const = default;
};

// The samples within [fromNm, toNm]; empty (count() <= 0) if there are none.
Band bandBetween(double fromNm, double toNm);

// Ultraviolet as the paper's "UVA": it includes UVB below 315 nm.
inline const Band kUltravioletBand = {0, 50};
inline const Band kVisibleBand = {50, 200};
inline const Band kNearInfraredBand = {200, 350};

}  // namespace cutis
