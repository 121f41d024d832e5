#pragma once

// The chromaticities that skin of a model can have: a sheet, spanned by melanin and dermal blood.
// What lies beside it is no skin, or was photographed under another light than is assumed.
//
// CIE 1976 u′, v′. Double precision; thread-safe: pure functions.

#include <vector>

#include <Eigen/Core>

#include "core/skin/model/skin_model.h"
#include "core/skin/profile/parameter.h"
#include "core/spectra/grid.h"

namespace cutis {

// u′ = 4 X / (X + 15 Y + 3 Z), v′ = 9 Y / (X + 15 Y + 3 Z); NaN where there is no light.
Eigen::Vector2d chromaticityOf(const Eigen::Vector3d& xyz);

// All colours of skin with this much of one parameter, while the other one grows.
struct LocusLine {
  Parameter parameter = kMelanin;  // or kHaemoglobinDermal
  double amount = 0.0;             // in its unit
  std::vector<Eigen::Vector2d> points;
};

// Lines at amounts that double or so from a few per cent of a range to all of it. others: of the
// three other parameters. tristimulus: tristimulusRows() of light and observer
// (core/spectra/colorimetry.h). About a hundred spectra: some 10 ms.
std::vector<LocusLine> skinLocus(const SkinModel& model, const ParameterVector& others,
                                 const SpectrumRows& tristimulus);

}  // namespace cutis
