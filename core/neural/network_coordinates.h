#pragma once  // internal to core/neural

// How networks see parameters: each as its position on the profile's table axis, from 0 to 1, in
// which spectra vary about evenly.
//
//   coordinate = (C / C_max)^(1/exponent)
//
// Sigmoids reach the open interval, so every answer of an
// encoder lies in the profile's box.

#include <cstdint>
#include <vector>

#include "core/skin/profile/parameter_axis.h"

namespace cutis {

double networkCoordinate(const ParameterAxis& axis, double value);
double parameterOfCoordinate(const ParameterAxis& axis, double coordinate);

// Whom to train on: a mixture of two populations.
struct TrainingPeople {
  // Share of people drawn evenly from the box of faces: that of the error protocol (FITTING: C_m
  // 0.01–0.25, β_m 0.2–1, C_hd 0.005–0.1, C_he 0–0.05, C_bc 0–0.004) with a margin of 8 % of its
  // width. The rest comes from the whole of the profile's box, in the density of its table.
  double faceShare = 0.7;
  int count = 300'000;
  std::uint64_t seed = 1;

  bool operator==(const TrainingPeople&) const = default;
};

// Deterministic; a person depends on the seed and their number alone.
std::vector<ParameterVector> drawTrainingPeople(const TrainingPeople& people,
                                                const ParameterAxes& axes);

}  // namespace cutis
