#pragma once

// Where along the wavelengths a channel sees: its middle, its width, and the range that all
// channels of a rig together have measured.
//
// Responses are those of responseRows() (core/rig/rig.h), not negative. Wavelengths in nm. Pure
// functions, thread-safe.

#include <optional>

#include "core/spectra/grid.h"

namespace cutis {

struct ChannelExtent {
  double effectiveNm = 0.0;  // Σ λ r / Σ r
  double deviationNm = 0.0;  // √(Σ (λ − effective)² r / Σ r); of a Gaussian, FWHM / 2.355
};

// None for a channel that sees nothing.
std::optional<ChannelExtent> channelExtent(const Spectrum& response);

// A channel measures from where it has seen this share of its light to where it has seen all but
// this share.
inline constexpr double kUnmeasuredShare = 0.01;

// From the first sample that any channel measures to the last; what lies beside it, a fit says by
// its model alone. None where no channel sees anything.
std::optional<Band> measuredBand(const SpectrumRows& responses);

}  // namespace cutis
