#pragma once

// What is known of the free constants before a pixel is measured: normal in the oxygenation and in
// the logarithm of the thickness, around the profile's own, independent of the parameters.
//
// How far people differ: the oxygenation that fit-spectra --free finds on measured skin with the
// profile skin2026 spreads by 0.18 over the Leeds/Liverpool spectra and by 0.08 over the NIST
// subjects (a third of the range of nine in ten), with the error of the search in it; 0.15 lies
// between. The thickness that it finds is no guide (resources/manual/fitting.md): 0.3 stands for
// what histology is remembered to say, a fifth within a site of the body and as much again between
// its sites (not consulted: Sandby-Møller, Poulsen & Wulf 2003). Thread-safe.

#include "core/skin/profile/free_constants.h"

namespace cutis {

struct FreePrior {
  SkinConstants mean;  // of the thickness the median
  double oxygenationDeviation = 0.15;
  double logThicknessDeviation = 0.3;  // of the natural logarithm

  // The standard deviation of a constant in its unit, at a value of it.
  double deviation(SkinConstant constant, double at) const {
    return constant == kOxygenation ? oxygenationDeviation : logThicknessDeviation * at;
  }
};

inline FreePrior usualFreePrior(const Profile& profile) {
  return {.mean = constantsOf(profile)};
}

}  // namespace cutis
