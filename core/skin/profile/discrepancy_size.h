#pragma once

// How many coefficients a discrepancy may have, and how large they may be: apart from
// core/skin/profile/discrepancy.h, because vectorised code includes no Eigen.

namespace cutis {

// More would cost the memory of maps more than they tell.
inline constexpr int kMaximumCoefficients = 8;

// A pixel's coefficients lie no further from 0 than this, so that what is no skin is not explained
// away and no reflectance turns negative.
inline constexpr double kMostCoefficientNorm = 4.0;

// The least that the factor of reflectance may be then.
inline constexpr double kLeastFactor = 0.05;

}  // namespace cutis
