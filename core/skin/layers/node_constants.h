#pragma once

// The numbers the vectorised kernels read at each node. Plain data: this header reaches code that
// is compiled for several instruction sets and therefore includes nothing but plain data.

#include "core/skin/layers/polynomial.h"

namespace cutis {

// Absorptions net of displaced tissue, as in core/skin/profile/absorption.h; mm⁻¹.
template <typename T>
struct NodeConstants {
  T epidermalScattering;
  T dermalScattering;
  T epidermalBase;
  T pheomelanin;
  T melaninContrast;  // eumelanin − pheomelanin
  T epidermalBlood;
  T carotene;
  T dermalBase;
  T dermalBlood;
  // Radiative transfer as a polynomial of the two absorptions; null: diffusion in closed form.
  const LayerPolynomial<T>* transport;
};

// Constants all nodes share. s = σ_tr ℓ lies in [0, √3].
template <typename T>
struct LayerConstants {
  T thicknessMm;  // of the epidermis
  T airGap;       // 4/3 A of the boundary to air
  // Polynomials in s, for single precision: e^(−s/3) and e^(−airGap · s/8).
  T innerDecay[6];
  T airDecay[7];
};

}  // namespace cutis
