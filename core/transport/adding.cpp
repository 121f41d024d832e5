#include "core/transport/adding.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/transport/fresnel.h"

namespace cutis {
namespace {

constexpr double kLargestAlbedo = 1.0 - 1e-12;

double scattering(const TransportLayer& layer, double anisotropy) {
  return layer.reducedScattering / (1.0 - anisotropy);
}

// Flux that enters diffusely in each stream, relative to the light that arrives over η².
template <int N>
StreamVector<N> diffuselyEntering(const Streams<N>& streams) {
  return streams.fluxRoot.array() * (1.0 - streams.reflectance.array());
}

}  // namespace

template <int N>
LitInterface<N> litSurface(const Streams<N>& streams, Illumination illumination) {
  StreamVector<N> entering = StreamVector<N>::Zero();
  if (illumination == Illumination::collimated) {
    entering[N - 1] = 1.0 / streams.fluxRoot[N - 1];
  } else {
    entering = diffuselyEntering(streams);
    entering /= streams.fluxRoot.dot(entering);
  }
  LitInterface<N> surface;
  surface.admittance = streams.surface.asDiagonal();
  // Downward light is ρ times upward light plus what enters.
  surface.source = 2.0 * entering.array() / (1.0 + streams.reflectance.array());
  surface.collector = streams.surface.cwiseProduct(streams.fluxRoot);
  surface.reflectance = -surface.collector.dot(entering);
  return surface;
}

template <int N>
double specularShare(const Streams<N>& streams, double index, Illumination illumination) {
  if (illumination == Illumination::collimated) return normalReflectance(index);
  return std::max(0.0, 1.0 - index * index * streams.fluxRoot.dot(diffuselyEntering(streams)));
}

template <int N>
LitInterface<N> below(const LitInterface<N>& above, const LayerAdmittance<N>& layer) {
  const StreamMatrix<N> entered = above.admittance + layer.even;
  const StreamMatrix<N> both = above.admittance + 0.5 * (layer.odd + layer.even);
  const Eigen::LLT<StreamMatrix<N>> decomposed(both);
  // With P = J Jᵀ every use of P⁻¹ is a product of J⁻¹ applied from both sides.
  const StreamMatrix<N> lost = decomposed.matrixL().solve(entered);
  const StreamVector<N> source = decomposed.matrixL().solve(above.source);
  const StreamVector<N> collector = decomposed.matrixL().solve(above.collector);
  LitInterface<N> interface;
  interface.admittance = entered + layer.even;
  interface.admittance.noalias() -= lost.transpose() * lost;
  interface.source = above.source - lost.transpose() * source;
  interface.collector = above.collector - lost.transpose() * collector;
  interface.reflectance = above.reflectance + collector.dot(source);
  return interface;
}

template <int N>
StreamVector<N> lightOver(const LitInterface<N>& interface, const StreamMatrix<N>& admittance) {
  const StreamMatrix<N> both = interface.admittance + admittance;
  return Eigen::LLT<StreamMatrix<N>>(both).solve(interface.source);
}

template <int N>
LayerEquation<N> equationOf(const Streams<N>& streams, const TransportLayer& layer,
                            double anisotropy) {
  const double scattered = scattering(layer, anisotropy);
  const double albedo = scattered / (layer.absorption + scattered);
  return layerEquation(streams, Scatterer{std::min(albedo, kLargestAlbedo), anisotropy});
}

double opticalDepth(const TransportLayer& layer, double anisotropy) {
  const double extinction = layer.absorption + scattering(layer, anisotropy);
  return extinction > 0.0 ? extinction * layer.thickness : 0.0;
}

#define CUTIS_INSTANTIATE(N)                                                          \
  template LitInterface<N> litSurface(const Streams<N>&, Illumination);               \
  template double specularShare(const Streams<N>&, double, Illumination);             \
  template LitInterface<N> below(const LitInterface<N>&, const LayerAdmittance<N>&);  \
  template StreamVector<N> lightOver(const LitInterface<N>&, const StreamMatrix<N>&); \
  template LayerEquation<N> equationOf(const Streams<N>&, const TransportLayer&, double);
CUTIS_INSTANTIATE(16)
CUTIS_INSTANTIATE(32)
#undef CUTIS_INSTANTIATE

}  // namespace cutis
