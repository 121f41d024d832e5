#include "core/transport/streams.h"

#include <cmath>

#include "core/maths/quadrature.h"
#include "core/transport/fresnel.h"

namespace cutis {
namespace {

template <int N>
void placeDirections(double index, Streams<N>& streams) {
  if (index == 1.0) {
    const Quadrature whole = radauQuadrature(N, 0.0, 1.0);
    streams.cosine = whole.nodes;
    streams.weight = whole.weights;
    return;
  }
  constexpr int half = N / 2;
  const Quadrature trapped = gaussQuadrature(half, 0.0, criticalCosine(index));
  streams.cosine.template head<half>() = trapped.nodes;
  streams.weight.template head<half>() = trapped.weights;
  const Quadrature inAir = radauQuadrature(half, 0.0, 1.0);
  for (int i = 0; i < half; ++i) {
    // η² μ dμ = μ_air dμ_air.
    const double inside = refractedCosine(inAir.nodes[i], index);
    streams.cosine[half + i] = inside;
    streams.weight[half + i] = inAir.weights[i] * inAir.nodes[i] / (index * index * inside);
  }
  streams.weight.template tail<half>() *=
      (1.0 - criticalCosine(index)) / streams.weight.template tail<half>().sum();
}

}  // namespace

template <int N>
Streams<N> makeStreams(double index) {
  Streams<N> streams;
  placeDirections(index, streams);
  streams.fluxRoot = (2.0 * streams.cosine.array() * streams.weight.array()).sqrt();
  for (int i = 0; i < N; ++i) {
    streams.reflectance[i] = internalReflectance(streams.cosine[i], index);
  }
  streams.surface = (1.0 - streams.reflectance.array()) / (1.0 + streams.reflectance.array());
  return streams;
}

template Streams<16> makeStreams<16>(double);
template Streams<32> makeStreams<32>(double);

}  // namespace cutis
