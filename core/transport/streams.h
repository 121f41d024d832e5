#pragma once  // internal to core/transport

// Discrete ordinates: the directions light takes inside the layers, one set per hemisphere.
//
// Half of the N directions lie beyond the critical angle of the surface (Gauss points in the cosine
// inside), half within it (Radau points in the cosine in air, in which the Fresnel transmittance is
// smooth, refracted by Snell's law), the last along the normal. Without a change of index all N are
// Radau points on [0, 1]. Weights are scaled to a sum of exactly 1 over the hemisphere, without
// which scattering would not conserve energy. Light is described by u_i = √(2 μ_i w_i) I_i:
// reciprocal operators are then symmetric, and the flux is Σ e_i u_i with e_i = √(2 μ_i w_i).
//
// Cosines rise; weights are those of ∫₀¹ dμ inside. Immutable, thread-safe.

#include <Eigen/Core>

namespace cutis {

template <int N>
using StreamVector = Eigen::Matrix<double, N, 1>;
template <int N>
using StreamMatrix = Eigen::Matrix<double, N, N>;

template <int N>
struct Streams {
  StreamVector<N> cosine;       // μ, in (0, 1]
  StreamVector<N> weight;       // w
  StreamVector<N> fluxRoot;     // e
  StreamVector<N> reflectance;  // ρ of the surface, from inside
  StreamVector<N> surface;      // (1 − ρ) / (1 + ρ): the surface's admittance
};

// Precondition: index ≥ 1. N is 8, 16 or 32.
template <int N>
Streams<N> makeStreams(double index);

}  // namespace cutis
