#pragma once  // internal to core/transport

// Doubling: the operators of a homogeneous layer from those of a very thin one.
//
// Lit alike from both sides a layer answers d = Y s at its faces, lit oppositely d = W s, with s
// the sum and d the difference of inward and outward light (core/transport/ordinates_equation.h).
// Reflection and transmission follow as
//
//   R + T = (1 − Y)(1 + Y)⁻¹,  R − T = (1 − W)(1 + W)⁻¹,
//
// and a layer laid on a copy of itself has the arithmetic mean of the two for W and their harmonic
// mean for Y:
//
//   W ← ½ (W + Y),  Y ← 2 Y − 2 Y (W + Y)⁻¹ Y.
//
// Both stay symmetric and positive definite, and perturbations die out, so that nothing cancels or
// grows however thick the layer or close to 1 its albedo. Both tend to the same limit, the
// half-space. With E of the layer's equation and h half its depth, Y = √E tanh √E h and
// W = √E coth √E h in the coordinates of E. The thinnest layer takes both from a Padé
// approximation at √E h ≤ ½, relative error 5e-11 (Wiscombe's diamond initialisation is its first
// term).
//
// Thread-safe. N = 16: about 3 µs a step on one core.

#include "core/transport/ordinates_equation.h"

namespace cutis {

template <int N>
struct LayerAdmittance {
  StreamMatrix<N> even;  // Y
  StreamMatrix<N> odd;   // W
};

// Precondition: opticalDepth > 0, finite.
template <int N>
LayerAdmittance<N> layerAdmittance(const LayerEquation<N>& equation, double opticalDepth);

// Semi-infinite layer: s and d at its surface are bound by d = Y s. Precondition: albedo below 1.
template <int N>
StreamMatrix<N> halfSpaceAdmittance(const LayerEquation<N>& equation);

}  // namespace cutis
