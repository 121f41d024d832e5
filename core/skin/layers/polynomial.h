#pragma once

// Reflectance of the two layers at one wavelength as a polynomial of two numbers, for the kernels.
// Plain data: this header reaches code that is compiled for several instruction sets and therefore
// includes nothing.
//
// With u = √σ_a each layer has
//
//   z = end − span / (u + knee),  dz/dσ_a = span / (2 u (u + knee)²),
//
// which rises from −1 to 1 over its range of absorption, and R = Σᵢ Σⱼ c[i][j] z_eⁱ z_dʲ. A layer
// of scattering σ_s' reflects nearly as a polynomial in such a z when the knee is of the order of
// √σ_s': that is why so few terms do (core/skin/layers/table.h).

namespace cutis {

inline constexpr int kEpidermalTerms = 10;  // powers of z_e, from 0
inline constexpr int kDermalTerms = 5;      // powers of z_d

// Absorption in mm⁻¹.
template <typename T>
struct AbsorptionScale {
  T low, high;   // range; 0 < low < high
  T knee, span;  // √mm⁻¹; positive
  T end;
};

// T is float or double.
template <typename T>
struct LayerPolynomial {
  AbsorptionScale<T> epidermis, dermis;
  T coefficients[kEpidermalTerms][kDermalTerms];
};

}  // namespace cutis
