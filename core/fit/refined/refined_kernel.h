#pragma once  // internal to core/fit/refined

// Vectorised Gauss–Newton for many pixels at once: the inner part of
// core/fit/refined/refined_solver.cpp. Plain data, see core/skin/layers/node_constants.h.
//
// One pixel a lane. A round evaluates the model at the trial point, accepts it or shortens the
// step, and solves for the next step. Rounds come in pairs: the first evaluates derivatives too and
// factorises the 5 × 5 normal equations, the second reuses both (a chord step), at less than half
// the cost. A lane stops when the step it is about to take would lower the cost by less than
// `tolerance`; lanes that need longer than their neighbours are put aside after a pair of rounds
// and share vectors of their own, so that finished ones cost nothing. What a lane goes through
// depends on its own pixel alone.

#include <cstddef>
#include <cstdint>

#include "core/base/pixel_rows.h"
#include "core/skin/layers/node_constants.h"
#include "core/skin/profile/discrepancy_size.h"
#include "core/skin/profile/parameter.h"

namespace cutis {

inline constexpr std::size_t kMaximumFitChannels = 32;
inline constexpr std::size_t kMaximumFitNodes = 48;
// Polynomial start: components of the log channels, and terms up to the fourth degree in them.
inline constexpr int kStartComponents = 4;
inline constexpr int kStartTerms = 70;
// One polynomial for dark skin, one for light: the first component, which is lightness, decides.
inline constexpr int kStartPieces = 2;

// Where a pixel begins, from its own channels.
struct StartPolynomial {
  // component = Σ_k projection[component][k] · ln(channel k) + offset[component]
  float projection[kStartComponents][kMaximumFitChannels];
  float offset[kStartComponents];
  // coordinate = Σ_t coefficients[piece][coordinate][t] · term t; terms in the order of
  // startTerms(). The first piece holds where the first component is below 0.
  float coefficients[kStartPieces][kParameterCount][kStartTerms];
};

template <typename T>
struct RefinedProblem {
  const NodeConstants<T>* nodes;
  std::size_t nodeCount;
  LayerConstants<T> layers;
  const T* weights;  // [channel][node]
  std::size_t channelCount;
  // A channel's variance is readVariance + proportionalVariance · (channel + veil)².
  T readVariance;
  T proportionalVariance;
  T veil;
  // Coordinates: the parameter, or its natural logarithm.
  bool isLog[kParameterCount];
  bool isFixed[kParameterCount];
  T low[kParameterCount];
  T high[kParameterCount];
  T priorMean[kParameterCount];  // of a fixed parameter: where it is fixed
  // Inverse covariance of the coordinates; no coupling with fixed ones.
  T priorPrecision[kParameterCount][kParameterCount];
  T priorDeviation[kParameterCount];  // of each coordinate by itself
  T rootOffset[kParameterCount];      // c where channels follow √(C + c); 0 where they follow C
  T shadingPrecision;                 // 1 / s² of a factor on all channels, 1 expected; 0: none
  // The profile's discrepancy (core/fit/refined/channel_discrepancy.h), if the fit has one.
  bool hasDiscrepancy;
  T channelOffset[kMaximumFitChannels];
  T channelSlope[kMaximumFitChannels][kParameterCount];
  T channelCovariance[kMaximumFitChannels * (kMaximumFitChannels + 1) / 2];  // lower triangle
  std::size_t coefficientCount;
  T coefficientOffset[kMaximumCoefficients];
  T coefficientSlope[kMaximumCoefficients][kParameterCount];
  T coefficientGain[kMaximumCoefficients][kMaximumFitChannels];
  T tolerance;  // in units of one standard deviation²
  int maximumRounds;
  const StartPolynomial* start;  // null: begin at the coordinates that come in
};

template <typename T>
struct RefinedPixels {
  PixelRows<const float> channels;
  PixelRows<T> coordinates;  // out, and in without a start polynomial
  std::uint8_t* converged;   // out
  std::uint16_t* rounds;     // added to
  T* costs = nullptr;        // out, [pixel]: what was minimised, where somebody asks
  // Out, where somebody asks and there is a discrepancy: its most probable coefficients at the
  // coordinates, but no further from 0 than kMostCoefficientNorm.
  PixelRows<float> coefficients = {};
};

// T is float or double.
template <typename T>
void runRefinedKernel(const RefinedProblem<T>& problem, const RefinedPixels<T>& pixels);

}  // namespace cutis
