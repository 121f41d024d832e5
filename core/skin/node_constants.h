#pragma once

// The numbers the vectorised kernels read at each node. Plain data: this header reaches code that is
// compiled for several instruction sets and therefore includes nothing.

namespace cutis {

// Absorptions net of displaced tissue, as in core/skin/absorption.h; mm⁻¹.
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
