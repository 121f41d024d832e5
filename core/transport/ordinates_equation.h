#pragma once  // internal to core/transport

// The transport equation of a homogeneous layer in discrete ordinates.
//
// With u⁺ going down, u⁻ going up (core/transport/streams.h), s = u⁺ + u⁻ and d = u⁺ − u⁻, and
// depth in units of the extinction,
//
//   s' = −B d,  d' = −A s,
//   A = M^−½ (1 − Cₑ) M^−½,  B = M^−½ (1 − Cₒ) M^−½,  M = diag μ,
//
// where Cₑ and Cₒ hold the even and the odd Legendre terms of the phase function times the albedo.
// Both are symmetric, B is positive definite, A at least semi-definite. In coordinates ŝ = L⁻¹ s
// and d̂ = Lᵀ d with B = L Lᵀ this is ŝ' = −d̂, d̂' = −E ŝ, E = Lᵀ A L: all the layer's operators are
// functions of the one symmetric matrix E, whose eigenvalues are the squared decay rates.

#include "core/transport/streams.h"

namespace cutis {

// What a layer is made of, once absorption and scattering are turned into albedo and depth.
struct Scatterer {
  double albedo = 0.0;      // of single scattering, in [0, 1]
  double anisotropy = 0.0;  // g of the Henyey–Greenstein phase function, in (−1, 1); 0: isotropic
};

template <int N>
struct LayerEquation {
  StreamMatrix<N> rates;  // E
  StreamMatrix<N> root;   // L, lower triangular
  double depthScale = 1;  // equation's depth per optical depth of the layer
};

// Anisotropic scattering is cut off at N Legendre terms by the delta-M method (Wiscombe 1977): what
// is scattered straight on counts as not scattered, which shortens the depth by 1 − a g^N. Rows are
// corrected on the diagonal so that scattering conserves energy to the last digits.
template <int N>
LayerEquation<N> layerEquation(const Streams<N>& streams, const Scatterer& scatterer);

}  // namespace cutis
