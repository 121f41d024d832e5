#pragma once

// The smooth surface between air and skin, for unpolarised light. The index is that of the skin
// over that of air, ≥ 1; cosines are of the angle to the normal, in [0, 1]. Thread-safe.

namespace cutis {

// Reflectance for light that arrives from inside; 1 beyond the critical angle.
double internalReflectance(double cosineInside, double index);

// Reflectance at normal incidence, from either side: ((η − 1) / (η + 1))².
double normalReflectance(double index);

// √(1 − 1/η²): light from inside at a smaller cosine is totally reflected. 0 for η = 1.
double criticalCosine(double index);

// Snell's law: cosine inside of a ray whose cosine in air is given.
double refractedCosine(double cosineInAir, double index);

}  // namespace cutis
