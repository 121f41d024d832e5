#pragma once  // internal to core/transport

// Adding: layers below a lit surface, one after another.
//
// In the sum s and difference d of downward and upward light (core/transport/doubling.h),
// everything above an interface binds the two by d = q − G s, and the light that re-emerges at the
// top is R = r + l · s. A layer with admittances Y and W, that is with ½ (W + Y) at its faces and ½
// (W − Y) through it, carries both to its lower face. With P = G + ½ (W + Y) and K = G + Y
//
//   r ← r + l P⁻¹ q,  G ← G + 2 Y − K P⁻¹ K,  q ← q − K P⁻¹ q,  l ← l − K P⁻¹ l,
//
// in which nothing is lost as the layer thins and W grows without bound;
// and whatever lies below, d = Y s, closes the system: (G + Y) s = q. This is the adding method of
// van de Hulst for a single illumination, with symmetric positive matrices in place of R and T.
// Thread-safe.

#include "core/transport/adding_doubling.h"
#include "core/transport/doubling.h"

namespace cutis {

template <int N>
struct LitInterface {
  StreamMatrix<N> admittance;  // G
  StreamVector<N> source;      // q
  StreamVector<N> collector;   // l
  double reflectance = 0.0;    // r
};

// The surface to air, lit by a flux of 1 that enters.
template <int N>
LitInterface<N> litSurface(const Streams<N>& streams, Illumination illumination);

// Share of the arriving light that the surface reflects.
template <int N>
double specularShare(const Streams<N>& streams, double index, Illumination illumination);

template <int N>
LitInterface<N> below(const LitInterface<N>& above, const LayerAdmittance<N>& layer);

// Light at the interface, s, over what has the admittance Y.
template <int N>
StreamVector<N> lightOver(const LitInterface<N>& interface, const StreamMatrix<N>& admittance);

// A layer's equation and optical depth; the depth of an infinite layer is infinite.
template <int N>
LayerEquation<N> equationOf(const Streams<N>& streams, const TransportLayer& layer,
                            double anisotropy);
double opticalDepth(const TransportLayer& layer, double anisotropy);

}  // namespace cutis
